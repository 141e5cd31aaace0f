package robotran.workshop.handins

import robotran.assignments.doing.HandedInWork
import robotran.assignments.doing.makeHandIn
import robotran.brick.controls.BrickButton
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.AssignmentChecks
import robotran.projects.AssignmentTries
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.WorldVariation
import robotran.projects.writeProject
import robotran.simulation.RecordedInput
import robotran.simulation.SessionInput
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.platform.OpenedFile

/** What a class has handed in for [AnyAssignment], honest and hostile. */
internal object AnyClass {
    /** Graded with ten seeds, in a world where the robot is exact, and in one where it strays. */
    val teachers: Project = AnyAssignment.teachers.run {
        val straying = WorldVariation("A worn robot", world.copy(realism = 1.0, timeLimit = 8))
        copy(
            world = world.copy(realism = 0.3, timeLimit = 8),
            assignment = assignment?.copy(checks = AssignmentChecks(1..10, listOf(straying))),
        )
    }

    fun robolang(text: String) = ProjectProgram(Program("circle.robo", ProgramLanguage.ROBOLANG, text))

    fun java(text: String) = ProjectProgram(Program("Circle.java", ProgramLanguage.JAVA, text))

    /** The run that the app records for a program that needs no touch. */
    private val RUN = listOf(SessionInput.Press(BrickButton.RUN, 0), SessionInput.Release(BrickButton.RUN, 0))
        .map { RecordedInput(0, it) }

    fun handIn(name: String, program: ProjectProgram, tries: Int = 3, of: Project = teachers): Project =
        makeHandIn(of.copy(tries = AssignmentTries(tries)), name, HandedInWork(listOf(program), inputs = RUN))

    fun file(name: String, program: ProjectProgram, tries: Int = 3, of: Project = teachers): OpenedFile =
        file(handIn(name, program, tries, of), name)

    fun file(handIn: Project, name: String) = OpenedFile("$name.robotran", writeProject(handIn).encodeToByteArray())

    fun text(name: String, text: String) = OpenedFile(name, text.encodeToByteArray())

    val solved = robolang("pen down\nforward 20\n")
    val copied = robolang("// My own idea!\npen down\n\nforward   20\n")
    val short = robolang("pen down\nforward 8\n")
    val lucky = robolang("pen down\nforward 16.4\n")
    val noPen = robolang("forward 20\n")
    val turning = robolang("pen down\nrepeat 4 times\n  forward 5\n  turn left 90\nend\nforward 20\n")
    val mistaken = robolang("pen down\nforwrd 20\n")
    val endless = robolang("repeat forever\n  beep\nend\n")

    /** Four who can, five who cannot yet in different ways, and one that makes no sense. */
    val few: List<OpenedFile> = listOf(
        file("Ada", solved, tries = 2),
        file("Ben", short, tries = 7),
        file("Cleo", lucky, tries = 12),
        file("Dina", mistaken),
        file("Emil", endless, tries = 1),
        text("Fritz.robotran", "{ \"format\": \"robotran-project\""),
    )

    private val names = listOf(
        "Ada Lovelace",
        "Ben",
        "Cleo",
        "Dina",
        "Emil",
        "Fatma",
        "Greta",
        "Hugo",
        "Ida",
        "Jan",
        "Kaya",
        "Lars",
        "Mina",
        "Noah",
        "Ole",
        "Paula",
        "Quentin",
        "Rosa",
        "Samir",
        "Tilda",
        "Umut",
    )
    private val programs = listOf(solved, turning, noPen, lucky, solved, short, turning, noPen, lucky, copied)

    /** 25 pupils. */
    val whole: List<OpenedFile> = names.mapIndexed { index, name ->
        file(name, programs[index * 7 % programs.size], tries = 1 + index * 5 % 9)
    } + listOf(
        file("Vera", mistaken),
        file("Wim", endless),
        text("Xenia.robotran", "{ \"format\": \"robotran-project\""),
        text("Yuri.robo", "pen down\nforward 20\n"),
    )
}
