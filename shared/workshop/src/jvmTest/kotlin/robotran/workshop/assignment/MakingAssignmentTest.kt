package robotran.workshop.assignment

import robotran.assignments.doing.firstPrograms
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.WorldGallery
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.readProject
import robotran.workshop.Workshop
import robotran.workshop.documents.Machine
import robotran.workshop.documents.write
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.examples.firstProgram
import robotran.workshop.platform.OpenedFile
import robotran.workshop.service.asProject
import robotran.workshop.state.AssignmentEditorState
import robotran.workshop.state.EditOrigin
import robotran.workshop.state.MissingPart
import robotran.workshop.state.PictureError
import robotran.workshop.state.SolutionCheck
import robotran.workshop.state.SolutionProgram
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import kotlin.io.encoding.Base64
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class MakingAssignmentTest {
    private val machine = Machine().apply { files.location = "/home/made.robotran" }

    private val Workshop.making: AssignmentEditorState get() = checkNotNull(state.making)

    private fun making(project: Project = AnyAssignment.teachers.copy(assignment = null)): Workshop =
        machine.window(AnyAssignment.request(project)).also { it.handle(AssignmentEvent.MakingRequested) }

    private fun saved(): Project =
        assertIs<ProjectFileResult.Success>(readProject(machine.files.disk.values.last(), Language.ENGLISH)).project

    private val Workshop.solutionText: String get() = making.assignment.solution.single().files.single().text

    private fun textOf(project: Project) = project.firstPrograms.single().files.single().text

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
        val robot = ProjectRobot(AnyAssignment.world.robots.first().name, listOf(firstProgram().asProject()))
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

    @Test
    fun `title, task and text are kept at once and can be undone`() {
        val workshop = making()
        workshop.handle(AssignmentEvent.TaskChanged("Another title", "Another task."))
        assertEquals("Another title", workshop.project.world.title)
        machine.clock.now += 10_000
        workshop.handle(AssignmentEvent.Changed(workshop.making.assignment.copy(text = "Read this.")))
        assertEquals("Read this.", workshop.project.assignment?.text)
        workshop.handle(AssignmentEvent.UndoRequested)
        assertEquals("", workshop.project.assignment?.text)
        workshop.handle(AssignmentEvent.UndoRequested)
        assertEquals("Into the circle", workshop.making.title)
        assertTrue(!workshop.making.canUndo)
        workshop.handle(AssignmentEvent.MakingClosed)
        assertEquals("Into the circle", workshop.state.world.title)
    }

    @Test
    fun `an empty title is not kept`() {
        val workshop = making()
        workshop.handle(AssignmentEvent.TaskChanged("", "Task."))
        assertEquals("", workshop.making.title)
        assertEquals("Into the circle", workshop.project.world.title)
    }

    @Test
    fun `a picture gets a mark in the text, and what is none is refused`() {
        val workshop = making()
        machine.files.chosen = listOf(OpenedFile("robot [1].png", Base64.decode(AnyAssignment.DOT)))
        workshop.handle(AssignmentEvent.PictureRequested)
        assertEquals("![robot 1](robot 1)\n", workshop.making.assignment.text)
        workshop.handle(AssignmentEvent.PictureRequested)
        assertEquals(listOf("robot 1", "robot 1 2"), workshop.making.assignment.pictures.map { it.name })
        machine.files.chosen = listOf(OpenedFile("a.png", "not a picture".encodeToByteArray()))
        workshop.handle(AssignmentEvent.PictureRequested)
        assertEquals(PictureError.NOT_A_PICTURE, workshop.making.pictureError)
        machine.files.chosen = listOf(OpenedFile("a.png", Base64.decode(AnyAssignment.DOT) + ByteArray(200_000)))
        workshop.handle(AssignmentEvent.PictureRequested)
        assertEquals(PictureError.TOO_LARGE, workshop.making.pictureError)
    }

    @Test
    fun `a variation is edited in the world editor, and the world stays as it is`() {
        val workshop = making()
        val world = workshop.project.world
        workshop.handle(AssignmentEvent.VariationAdded("Further away"))
        assertNull(workshop.state.making)
        assertEquals(EditOrigin("Into the circle", "Further away"), workshop.state.worldEdit?.origin)
        val edited = checkNotNull(workshop.state.worldEdit).editing.world
        val robot = edited.robots.first()
        val moved = robot.copy(start = robot.start.copy(x = robot.start.x + 5))
        workshop.handle(
            WorldEditEvent.Edited(WorldEdit.Change(ElementRef(ElementKind.ROBOT, 0), Element.OfRobot(moved))),
        )
        workshop.handle(WorldEditEvent.TriedOut)
        assertEquals(world, workshop.project.world)
        val variation = checkNotNull(workshop.making.assignment.checks).variations.single()
        assertEquals("Further away", variation.name)
        assertEquals(moved.start, variation.world.robots.first().start)
        assertTrue(!workshop.state.running)
        workshop.handle(AssignmentEvent.VariationOpened(0))
        assertEquals(variation.world, checkNotNull(workshop.state.worldEdit).editing.world)
        workshop.handle(WorldEditEvent.EditorClosed)
        assertNotNull(workshop.state.making)
    }

    @Test
    fun `the world editor leads back to the page`() {
        val workshop = making()
        workshop.handle(AssignmentEvent.WorldRequested)
        assertEquals(EditOrigin("Into the circle", null), workshop.state.worldEdit?.origin)
        workshop.handle(WorldEditEvent.EditorClosed)
        assertNotNull(workshop.state.making)
        workshop.handle(AssignmentEvent.WorldRequested)
        workshop.handle(WorldEditEvent.TriedOut)
        assertNull(workshop.state.making)
        assertTrue(workshop.state.running)
        workshop.handle(WorldEditEvent.EditorOpened)
        assertNull(workshop.state.worldEdit?.origin)
        workshop.handle(WorldEditEvent.EditorClosed)
        assertNull(workshop.state.making)
    }

    @Test
    fun `the solution is run with all seeds and variations`() {
        val workshop = making(AnyAssignment.teachers)
        workshop.handle(AssignmentEvent.CheckRequested(on = true))
        assertEquals(SolutionCheck.Passed(runs = 6), workshop.making.check)
        val wrong = workshop.making.assignment.copy(solution = listOf(AnyAssignment.program("forward 5\n")))
        workshop.handle(AssignmentEvent.Changed(wrong))
        assertNull(workshop.making.check)
        workshop.handle(AssignmentEvent.CheckRequested(on = true))
        assertEquals(SolutionCheck.Failed(failed = 6, runs = 6, world = "", seed = 1), workshop.making.check)
        val begun = workshop.making.assignment.copy(
            start = listOf(AnyAssignment.program("beep\n" + AnyAssignment.SOLUTION)),
            solution = AnyAssignment.assignment.solution,
        )
        workshop.handle(AssignmentEvent.Changed(begun))
        workshop.handle(AssignmentEvent.CheckRequested(on = true))
        assertEquals(SolutionCheck.Passed(runs = 6, startPassed = 6), workshop.making.check)
        workshop.handle(AssignmentEvent.Changed(wrong.copy(solution = listOf(AnyAssignment.program("forwrad\n")))))
        workshop.handle(AssignmentEvent.CheckRequested(on = true))
        assertIs<SolutionCheck.HasErrors>(workshop.making.check)
    }

    @Test
    fun `the link for pupils opens without checks`() {
        val workshop = making(AnyAssignment.teachers)
        workshop.handle(AssignmentEvent.PupilLinkRequested)
        workshop.handle(AssignmentEvent.PupilLinkCopied)
        assertEquals(true, workshop.making.link?.isCopied)
        val pupils = machine.window()
        pupils.handle(robotran.workshop.event.DocumentEvent.LinkOpened(checkNotNull(machine.clipboard.text)))
        assertNull(checkNotNull(pupils.state.assignment).assignment.checks)
    }

    @Test
    fun `the solution comes into the editor, and removing makes a project like any other`() {
        val workshop = making(AnyAssignment.teachers)
        workshop.handle(AssignmentEvent.SolutionShown)
        assertEquals(AnyAssignment.SOLUTION, workshop.state.programText)
        workshop.handle(AssignmentEvent.MakingRequested)
        workshop.handle(AssignmentEvent.Removed)
        assertNull(workshop.state.assignment)
        assertNull(workshop.state.making)
    }
}
