package robotran.workshop.assignment

import robotran.assignments.doing.firstPrograms
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.WorldGallery
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.workshop.Workshop
import robotran.workshop.documents.write
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.examples.firstProgram
import robotran.workshop.service.asProject
import robotran.workshop.state.MissingPart
import robotran.workshop.state.SolutionProgram
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Which programs of an author are the solution, and with which pupils begin. */
class ChosenProgramsTest : MakingAssignments() {
    @Test
    fun `a project becomes an assignment, to begin with its programs`() {
        val workshop = making()
        assertNotNull(workshop.project.assignment?.checks)
        assertEquals("Into the circle", workshop.making.title)
        assertEquals(listOf("circle.robo"), workshop.making.programs.filter { it.isStart }.map { it.name })
        assertEquals(listOf(MissingPart.SOLUTION), workshop.making.missing)
    }

    @Test
    fun `pupils begin with nothing rather than with the program that the app has opened`() {
        val robot =
            ProjectRobot(AnyAssignment.world.robots.first().name, listOf(firstProgram(Language.ENGLISH).asProject()))
        val workshop = making(Project(AnyAssignment.world, listOf(robot)))
        assertEquals(listOf(false), workshop.making.programs.map { it.isStart })
        workshop.handle(AssignmentEvent.PupilFileSaved)
        assertEquals("", textOf(saved()))
        workshop.handle(AssignmentEvent.StartSwitched(0, on = true))
        assertEquals(listOf("square.robo"), workshop.making.assignment.start.map { it.name })
        workshop.handle(AssignmentEvent.StartSwitched(0, on = false))
        assertEquals(listOf(false), workshop.making.programs.map { it.isStart })
        workshop.handle(AssignmentEvent.PupilFileSaved)
        assertEquals("", textOf(saved()))
    }

    private fun withPrograms(vararg texts: Pair<String, String>): Project {
        val programs = texts.map { (name, text) -> AnyAssignment.program(text, name) }
        return Project(AnyAssignment.world, listOf(ProjectRobot(AnyAssignment.world.robots.first().name, programs)))
    }

    @Test
    fun `a program that solves the task is the solution and not what pupils begin with, although it never ran`() {
        val workshop = making(withPrograms("mine.robo" to AnyAssignment.SOLUTION))
        assertEquals(listOf(false), workshop.making.programs.map { it.isStart })
        assertEquals(AnyAssignment.SOLUTION, workshop.solutionText)
        workshop.handle(AssignmentEvent.PupilFileSaved)
        assertEquals("", textOf(saved()))
    }

    @Test
    fun `a copy of the solution with other blanks and comments stays with the teacher, too`() {
        val copy = "// mine\n\n" + AnyAssignment.SOLUTION.replace(" ", "  ")
        val workshop = making(withPrograms("a.robo" to AnyAssignment.SOLUTION, "b.robo" to copy, "c.robo" to "beep\n"))
        assertEquals(listOf("c.robo"), workshop.making.programs.filter { it.isStart }.map { it.name })
        workshop.handle(AssignmentEvent.StartSwitched(1, on = true))
        workshop.handle(AssignmentEvent.PupilFileSaved)
        assertEquals("beep\n", textOf(saved()))
    }

    private val Workshop.begunWith: List<String> get() = making.programs.filter { it.isStart }.map { it.name }

    @Test
    fun `pupils do not begin with the solution, and the page says so where it is chosen`() {
        val copy = "// mine\n\n" + AnyAssignment.SOLUTION.replace(" ", "  ")
        val workshop = making(withPrograms("mine.robo" to AnyAssignment.SOLUTION, "copy.robo" to copy))
        assertEquals(listOf(true, false), workshop.making.solution.map { it.isTaken })
        workshop.handle(AssignmentEvent.StartSwitched(0, on = true))
        assertEquals(listOf("mine.robo") to emptyList(), workshop.making.notGiven to workshop.begunWith)
        workshop.handle(AssignmentEvent.StartSwitched(1, on = true))
        assertEquals(listOf("copy.robo") to emptyList(), workshop.making.notGiven to workshop.begunWith)
        workshop.handle(AssignmentEvent.PupilFileSaved)
        assertEquals("", textOf(saved()))
        workshop.handle(AssignmentEvent.SolutionSwitched(0, on = false))
        workshop.handle(AssignmentEvent.StartSwitched(0, on = true))
        assertEquals(emptyList<String>() to listOf("mine.robo"), workshop.making.notGiven to workshop.begunWith)
    }

    @Test
    fun `a program that becomes the solution is no longer what pupils begin with, and the page says so`() {
        val workshop = making(withPrograms("a.robo" to "beep\n", "b.robo" to "forward 1\n"))
        assertEquals(listOf("a.robo", "b.robo"), workshop.begunWith)
        workshop.handle(AssignmentEvent.SolutionSwitched(1, on = true))
        assertEquals(listOf("b.robo") to listOf("a.robo"), workshop.making.notGiven to workshop.begunWith)
        workshop.handle(AssignmentEvent.UndoRequested)
        assertEquals(emptyList<String>() to listOf("a.robo", "b.robo"), workshop.making.notGiven to workshop.begunWith)
    }

    @Test
    fun `where nothing is chosen, pupils begin with an empty program that has the first name`() {
        val workshop = making(withPrograms("program.robo" to AnyAssignment.SOLUTION))
        assertEquals("program.robo" to emptyList(), workshop.making.emptyStart to workshop.begunWith)
        workshop.handle(AssignmentEvent.PupilFileSaved)
        assertEquals("program.robo", saved().firstPrograms.single().name)
        assertEquals("", textOf(saved()))
        for ((solution, empty) in listOf("Mine.java" to "Program.java", "mine.nqc" to "program.nqc")) {
            val language = checkNotNull(ProgramLanguage.entries.find { solution.endsWith(it.extension) })
            val written = ProjectProgram(Program(solution, language, "// mine"))
            workshop.handle(AssignmentEvent.Changed(workshop.making.assignment.copy(solution = listOf(written))))
            assertEquals(empty, workshop.making.emptyStart)
        }
        workshop.handle(AssignmentEvent.StartSwitched(0, on = true))
        assertEquals(null to listOf("program.robo"), workshop.making.emptyStart to workshop.begunWith)
    }

    @Test
    fun `an empty program of the editor can be what pupils begin with`() {
        val workshop = making(withPrograms("empty.robo" to "", "mine.robo" to AnyAssignment.SOLUTION))
        assertEquals("empty.robo" to listOf("empty.robo"), workshop.making.emptyStart to workshop.begunWith)
        workshop.handle(AssignmentEvent.StartSwitched(0, on = false))
        assertEquals("program.robo" to emptyList(), workshop.making.emptyStart to workshop.begunWith)
    }

    @Test
    fun `sharing what solves the task asks first, and once`() {
        val workshop = making(withPrograms("mine.robo" to AnyAssignment.SOLUTION))
        workshop.handle(AssignmentEvent.SolutionSwitched(0, on = false))
        workshop.handle(AssignmentEvent.StartSwitched(0, on = true))
        workshop.handle(AssignmentEvent.PupilFileSaved)
        assertTrue(workshop.making.asksBeforeGiving)
        workshop.handle(AssignmentEvent.GivingCancelled)
        assertTrue(!workshop.making.asksBeforeGiving && machine.files.disk.isEmpty())
        workshop.handle(AssignmentEvent.PupilFileSaved)
        workshop.handle(AssignmentEvent.GivingConfirmed)
        assertEquals(AnyAssignment.SOLUTION, textOf(saved()))
        workshop.handle(AssignmentEvent.PupilFileSaved)
        assertTrue(!workshop.making.asksBeforeGiving)
    }

    @Test
    fun `solution and beginning come from the same tab, and pupils get the beginning only`() {
        val workshop = making()
        workshop.write(AnyAssignment.SOLUTION)
        workshop.handle(AssignmentEvent.SolutionTaken)
        assertEquals(emptyList(), workshop.making.missing)
        workshop.handle(AssignmentEvent.PupilFileSaved)
        assertEquals(AnyAssignment.BEGIN, textOf(saved()))
        assertNull(saved().assignment?.checks)
        assertEquals(emptyList(), saved().assignment?.solution)
        workshop.handle(AssignmentEvent.TeacherFileSaved)
        assertEquals(AnyAssignment.BEGIN, textOf(saved()))
        assertEquals(AnyAssignment.SOLUTION, saved().assignment?.solution?.single()?.files?.single()?.text)
        assertEquals("made.robotran", workshop.making.savedAs)
    }

    @Test
    fun `the solution of a world of the gallery is offered in the language of the assignment`() {
        val world = checkNotNull(WorldGallery.named("nxt-square"))
        val lesson = checkNotNull(world.lesson)
        val robot = ProjectRobot(world.plainWorld.robots.first().name, listOf(AnyAssignment.program("forward 1")))
        val workshop = making(Project(world.world(Language.GERMAN), listOf(robot)))
        val offered = SolutionProgram("solution.robo", false, isChanged = false, isOpen = false, isOfWorld = true)
        assertEquals(offered, workshop.making.solution.last())
        assertEquals(emptyList(), workshop.making.assignment.solution)
        workshop.handle(AssignmentEvent.SolutionSwitched(workshop.making.solution.lastIndex, on = true))
        assertEquals(lesson.solution.text, workshop.solutionText)
        assertEquals(emptyList(), workshop.making.missing)
        assertEquals(offered.copy(isTaken = true, isOfWorld = false), workshop.making.solution.last())
        workshop.handle(AssignmentEvent.UndoRequested)
        workshop.handle(
            AssignmentEvent.Changed(workshop.making.assignment.copy(languages = listOf(ProgramLanguage.JAVA))),
        )
        assertEquals("Solution.java", workshop.making.solution.last().name)
        workshop.handle(
            AssignmentEvent.Changed(workshop.making.assignment.copy(languages = listOf(ProgramLanguage.NQC))),
        )
        assertTrue(workshop.making.solution.none { it.isOfWorld })
    }

    @Test
    fun `what pupils begin with and what Show me has shown is not the solution until it is ticked`() {
        val gallery = checkNotNull(WorldGallery.worlds.firstNotNullOf { it.lesson })
        val shown = AnyAssignment.program(gallery.solution.text, "solution.robo")
        val robot =
            ProjectRobot(
                AnyAssignment.world.robots.first().name,
                listOf(AnyAssignment.program(AnyAssignment.BEGIN), shown),
            )
        val workshop = making(Project(AnyAssignment.world, listOf(robot)))
        assertEquals(listOf("circle.robo"), workshop.making.programs.filter { it.isStart }.map { it.name })
        assertEquals(emptyList(), workshop.making.assignment.solution)
        workshop.handle(AssignmentEvent.MakingClosed)
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("mine.robo", "")))
        workshop.write(AnyAssignment.SOLUTION)
        workshop.handle(AssignmentEvent.MakingRequested)
        assertEquals(listOf(false, false, true), workshop.making.solution.map { it.isTaken })
        assertEquals(AnyAssignment.SOLUTION, workshop.solutionText)
        assertTrue(!workshop.making.canTakeSolution)
        workshop.handle(AssignmentEvent.SolutionSwitched(2, on = false))
        workshop.handle(AssignmentEvent.SolutionSwitched(1, on = true))
        assertEquals(listOf("solution.robo"), workshop.making.assignment.solution.map { it.name })
        workshop.handle(AssignmentEvent.UndoRequested)
        assertEquals(emptyList(), workshop.making.assignment.solution)
        workshop.handle(AssignmentEvent.SolutionTaken)
        assertEquals(AnyAssignment.SOLUTION, workshop.solutionText)
    }

    @Test
    fun `a program of the solution that is changed or closed stays as it was until it is taken again`() {
        val workshop = making()
        workshop.write(AnyAssignment.SOLUTION)
        workshop.handle(AssignmentEvent.SolutionTaken)
        workshop.write(AnyAssignment.SOLUTION + "beep\n")
        workshop.handle(AssignmentEvent.MakingClosed)
        workshop.handle(AssignmentEvent.MakingRequested)
        assertEquals(SolutionProgram("circle.robo", true, isChanged = true, isOpen = true), workshop.making.solution[0])
        assertEquals(AnyAssignment.SOLUTION, workshop.solutionText)
        workshop.handle(AssignmentEvent.SolutionTaken)
        assertEquals(AnyAssignment.SOLUTION + "beep\n", workshop.solutionText)
        val closed = listOf(AnyAssignment.program("forward 20\n", "closed.robo"))
        workshop.handle(AssignmentEvent.Changed(workshop.making.assignment.copy(solution = closed)))
        assertEquals(
            SolutionProgram("closed.robo", true, isChanged = false, isOpen = false),
            workshop.making.solution[1],
        )
        workshop.handle(AssignmentEvent.SolutionSwitched(1, on = false))
        assertEquals(emptyList(), workshop.making.assignment.solution)
    }

    @Test
    fun `what pupils begin with never takes the place of a solution with its name`() {
        val workshop = making(AnyAssignment.teachers)
        val row = SolutionProgram("circle.robo", isTaken = true, isChanged = false, isOpen = false)
        assertEquals(listOf(row), workshop.making.solution)
        assertTrue(!workshop.making.canTakeSolution)
        workshop.handle(AssignmentEvent.SolutionTaken)
        assertEquals(AnyAssignment.SOLUTION, workshop.solutionText)
    }

    @Test
    fun `the program that has just met all goals is the solution of a new assignment`() {
        val workshop = machine.window(AnyAssignment.request(AnyAssignment.teachers.copy(assignment = null)))
        workshop.write(AnyAssignment.SOLUTION)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(20_000)
        workshop.handle(AssignmentEvent.MakingRequested)
        assertEquals(AnyAssignment.SOLUTION, workshop.solutionText)
        workshop.handle(AssignmentEvent.PupilFileSaved)
        assertEquals("", textOf(saved()))
    }
}
