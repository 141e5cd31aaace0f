package robotran.workshop.assignment

import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.AssignmentHint
import robotran.projects.AssignmentPicture
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.WorldVariation
import robotran.projects.writeProject
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

/** An assignment as its author has it: drive 20 cm ahead and draw at least 5 cm. */
internal object AnyAssignment {
    const val BEGIN = "// Drive into the circle.\n"
    const val SOLUTION = "pen down\nforward 20\n"

    val world: World = BuiltInWorlds.plain.run {
        val start = robots.first().start
        val angle = start.heading * PI / 180
        val target = Shape.Circle(Point(start.x + 20 * cos(angle), start.y + 20 * sin(angle)), 4.0)
        copy(
            title = "Into the circle",
            task = "Drive into the circle, and draw on the way.",
            goals = listOf(
                Goal(GoalCondition.Reach(target)),
                Goal(GoalCondition.InkLength(atLeast = 5.0, atMost = null)),
            ),
        )
    }

    fun program(text: String, name: String = "circle.robo") =
        ProjectProgram(Program(name, ProgramLanguage.ROBOLANG, text))

    val assignment = Assignment(
        id = "circle-1",
        text = "The robot stands in the middle. `forward 20` takes it 20 cm ahead.\n\n" +
            "![A dot](dot)\n\nWrite it yourself.",
        pictures = listOf(AssignmentPicture("dot", DOT)),
        hints = listOf(
            AssignmentHint("Does the robot move at all?", "never moved"),
            AssignmentHint("Think of the pen.", condition = null, afterTries = 2),
        ),
        due = "Friday",
        nameWanted = "First name and class",
        checks = AssignmentChecks(1..3, listOf(WorldVariation("Small", world))),
        solution = listOf(program(SOLUTION)),
    )

    val teachers =
        Project(world, listOf(ProjectRobot(world.robots.first().name, listOf(program(BEGIN)))), assignment = assignment)

    fun file(project: Project, name: String = "circle.robotran") =
        OpenedFile(name, writeProject(project).encodeToByteArray(), "/home/$name")

    fun request(project: Project) = OpenRequest.OfFiles(listOf(file(project)))

    /** A PNG picture of one pixel. */
    const val DOT = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAChwGA60e6kgAAAABJRU5ErkJggg=="
}
