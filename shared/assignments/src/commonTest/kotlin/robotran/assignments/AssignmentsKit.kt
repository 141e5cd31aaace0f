package robotran.assignments

import robotran.assignments.collecting.CollectedFile
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.collectHandIns
import robotran.assignments.doing.sealedHandIn
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.HandIn
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.WorldVariation
import robotran.projects.writeProject
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.file.BuiltInWorlds

internal const val DRAWS = "pen down\nforward 12\n"

/** To drive for ten centimetres of ink, with two seeds in two worlds. */
internal val ASSIGNMENT: Project = run {
    val world = BuiltInWorlds.plain.copy(
        title = "Draw",
        goals = listOf(Goal(GoalCondition.InkLength(atLeast = 10.0, atMost = null))),
        timeLimit = 10,
    )
    Project(
        world,
        assignment = Assignment(
            "draw-1",
            checks = AssignmentChecks(1..2, listOf(WorldVariation("other", world.copy(realism = 0.5)))),
        ),
    )
}

internal fun robolang(text: String, name: String = "prog.robo") =
    ProjectProgram(Program(name, ProgramLanguage.ROBOLANG, text))

internal fun java(text: String, name: String = "Prog.java") = ProjectProgram(Program(name, ProgramLanguage.JAVA, text))

internal fun handIn(
    name: String,
    programs: List<ProjectProgram> = listOf(robolang(DRAWS)),
    tries: Int = 1,
    assignment: Project = ASSIGNMENT,
): Project = sealedHandIn(
    Project(
        assignment.world,
        listOf(ProjectRobot(assignment.world.robots.first().name, programs)),
        assignment = Assignment(checkNotNull(assignment.assignment).id),
        handIn = HandIn(name, tries, null, ""),
    ),
)

internal fun file(path: String, text: String) = CollectedFile(path, text.encodeToByteArray())

internal fun file(path: String, project: Project) = file(path, writeProject(project))

internal suspend fun collect(vararg files: CollectedFile, assignment: Project = ASSIGNMENT): List<Submission> =
    collectHandIns(files.toList(), assignment, Language.ENGLISH).submissions
