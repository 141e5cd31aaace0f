package robotran.workshop.assignment

import kotlinx.coroutines.runBlocking
import robotran.assignments.doing.NotAllowed
import robotran.assignments.doing.firstPrograms
import robotran.assignments.doing.pupilCopy
import robotran.blockediting.palette.Palette
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.projects.Assignment
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.workshop.Workshop
import robotran.workshop.blocks.DragPayload
import robotran.workshop.documents.Machine
import robotran.workshop.documents.keep
import robotran.workshop.documents.projects
import robotran.workshop.documents.write
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.AssignmentState
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class DoingAssignmentTest {
    private val machine = Machine()
    private val pupils = pupilCopy(AnyAssignment.teachers)

    private fun with(change: (Assignment) -> Assignment): Project =
        pupils.copy(assignment = change(checkNotNull(pupils.assignment)))

    private fun window(project: Project = pupils): Workshop = machine.window(AnyAssignment.request(project))

    private val Workshop.doing: AssignmentState get() = checkNotNull(state.assignment)

    private fun Workshop.attempt(text: String, milliseconds: Int = 20_000) {
        handle(ProgramEvent.ProgramEdited(text))
        handle(RunEvent.RunPressed)
        advance(milliseconds)
    }

    @Test
    fun `an assignment opens with its task in sight and no tries`() {
        val workshop = window()
        assertTrue(workshop.state.hasTask && workshop.state.taskShown)
        assertEquals(0, workshop.doing.tries.tries)
        assertNull(workshop.doing.tries.best)
        assertEquals(AnyAssignment.BEGIN, workshop.state.programText)
    }

    @Test
    fun `each run that ends is a try, and the best is kept with its programs and inputs`() {
        val workshop = window()
        workshop.attempt("forward 5\n")
        workshop.attempt(AnyAssignment.SOLUTION)
        workshop.attempt("wait 1 second\n${AnyAssignment.SOLUTION}")
        workshop.attempt("beep\n")
        val tries = workshop.doing.tries
        assertEquals(4, tries.tries)
        val best = assertNotNull(tries.best)
        assertEquals(AnyAssignment.SOLUTION, best.programs.single().files.single().text)
        assertTrue(best.result.isSolved)
        assertEquals(2, best.inputs.size)
        assertEquals(tries, workshop.project.tries)
    }

    @Test
    fun `an unfinished run is no try, and looking back is none`() {
        val workshop = window()
        workshop.attempt("forward 5\n", milliseconds = 200)
        assertEquals(0, workshop.doing.tries.tries)
        workshop.advance(20_000)
        assertEquals(1, workshop.doing.tries.tries)
        workshop.handle(RunEvent.Scrubbed(100))
        workshop.advance(20_000)
        assertEquals(1, workshop.doing.tries.tries)
    }

    @Test
    fun `lines that run at once are no try`() {
        val workshop = window()
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        workshop.handle(ProgramEvent.ProgramEdited("forward 20\n"))
        workshop.handle(BlockEvent.SnippetRequested(DragPayload.New(Palette.blocks.first { it.id == "move" })))
        workshop.advance(20_000)
        assertEquals(0, workshop.doing.tries.tries)
    }

    @Test
    fun `the tries are there again after a restart`() {
        window().apply {
            attempt(AnyAssignment.SOLUTION)
            runBlocking { assertTrue(closeDocument()) }
        }
        val again = machine.window()
        assertEquals(1, again.doing.tries.tries)
        assertNotNull(again.doing.tries.best)
        assertTrue(again.doing.canBeginAgain)
    }

    @Test
    fun `hints fit what went wrong, others wait for their number of tries`() {
        val workshop = window()
        workshop.attempt("beep\n")
        assertEquals(listOf("Does the robot move at all?"), workshop.doing.hints.map { it.text })
        workshop.attempt("forward 20\n")
        assertEquals(listOf("Think of the pen."), workshop.doing.hints.map { it.text })
        workshop.attempt(AnyAssignment.SOLUTION)
        assertEquals(emptyList(), workshop.doing.hints)
    }

    @Test
    fun `beginning again puts the first program back, and undoing brings the pupil's own`() {
        val workshop = window()
        assertFalse(workshop.doing.canBeginAgain)
        workshop.write("forward 3\n")
        assertTrue(workshop.doing.canBeginAgain)
        workshop.handle(AssignmentEvent.BegunAgain)
        assertEquals(AnyAssignment.BEGIN, workshop.state.programText)
        workshop.handle(ProgramEvent.Undone)
        assertEquals("forward 3\n", workshop.state.programText)
    }

    @Test
    fun `beginning again restores exactly the programs and files given, and one touch undoes that`() {
        val files = listOf(SourceFile("Drive.java", "class Drive {}\n"), SourceFile("Other.java", "class Other {}\n"))
        val java = ProjectProgram(Program("Drive.java", ProgramLanguage.JAVA, files))
        val name = pupils.world.robots.first().name
        val workshop = window(
            pupils.copy(robots = listOf(ProjectRobot(name, listOf(java, AnyAssignment.program(AnyAssignment.BEGIN))))),
        )
        val given = workshop.project.firstPrograms
        workshop.handle(ProgramEvent.FileChosen(1))
        workshop.handle(ProgramEvent.FileClosed(1))
        workshop.handle(ProgramEvent.ProgramEdited("class Drive { int mine; }\n"))
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("mine.robo", "forward 1\n")))
        val own = workshop.project.firstPrograms
        workshop.handle(AssignmentEvent.BegunAgain)
        assertEquals(given, workshop.project.firstPrograms)
        assertFalse(workshop.doing.canBeginAgain)
        assertEquals(Notice.BegunAgain, workshop.state.notice)
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(own, workshop.project.firstPrograms)
        assertNull(workshop.state.notice)
        assertTrue(workshop.doing.canBeginAgain)
    }

    @Test
    fun `what was written after beginning again is not undone by its notice, and the tries stay`() {
        val workshop = window()
        workshop.attempt("forward 5\n")
        val tries = workshop.doing.tries
        workshop.handle(AssignmentEvent.BegunAgain)
        assertEquals(tries, workshop.doing.tries)
        workshop.write("forward 7\n")
        assertNull(workshop.state.notice)
        assertEquals("forward 7\n", workshop.state.programText)
    }

    @Test
    fun `the offer to undo beginning again goes with its project`() {
        val workshop = window()
        workshop.attempt("forward 5\n")
        workshop.handle(AssignmentEvent.BegunAgain)
        assertEquals(Notice.BegunAgain, workshop.state.notice)
        workshop.services.editor.openProject(Project(AnyAssignment.world))
        assertNull(workshop.state.notice)
    }

    @Test
    fun `the start program is not the best try once another has as many goals, and the nearest stays`() {
        val workshop = window()
        workshop.attempt(AnyAssignment.BEGIN + "beep\n")
        workshop.handle(AssignmentEvent.BegunAgain)
        workshop.attempt("forward 12\n")
        workshop.attempt("forward 2\n")
        val best = assertNotNull(workshop.doing.tries.best)
        assertEquals("forward 12\n", best.programs.single().files.single().text)
        assertTrue(assertNotNull(best.percent) > 0)
    }

    @Test
    fun `what is not allowed leads to its line`() {
        val workshop = window(with { it.copy(words = listOf("forward")) })
        workshop.handle(ProgramEvent.ProgramEdited("forward 5\nbackward 5\n"))
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("other.robo", "beep\n")))
        workshop.handle(AssignmentEvent.NotAllowedShown(workshop.doing.notAllowed.first()))
        assertEquals(0, workshop.state.programs.shownProgram)
        assertEquals(1, workshop.state.programs.draft.run { lines.lineOf(selection.caret) })
        assertEquals(Pane.PROGRAM, workshop.state.pane)
    }

    @Test
    fun `whether the task is folded is remembered on the device`() {
        window().apply {
            assertNull(doing.isTaskFolded)
            handle(AssignmentEvent.TaskFolded(true))
            assertEquals(true, doing.isTaskFolded)
            runBlocking { assertTrue(closeDocument()) }
        }
        assertEquals(true, machine.window().doing.isTaskFolded)
    }

    @Test
    fun `the world cannot be edited, unless the assignment allows it`() {
        val locked = window()
        locked.handle(WorldEditEvent.EditorOpened)
        assertNull(locked.state.worldEdit)
        assertEquals(Notice.WorldOfAssignment, locked.state.notice)
        val open = window(with { it.copy(id = "open", mayChangeWorld = true) })
        open.handle(WorldEditEvent.EditorOpened)
        assertNotNull(open.state.worldEdit)
    }

    @Test
    fun `words and languages that are not allowed are told with their lines`() {
        val workshop = window(with { it.copy(words = listOf("forward"), languages = listOf(ProgramLanguage.ROBOLANG)) })
        workshop.handle(ProgramEvent.ProgramEdited("forward 5\nbackward 5\n"))
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("Other.java", "class Other {}\n")))
        assertEquals(
            listOf(
                NotAllowed.HasWord("circle.robo", "backward", 2),
                NotAllowed.InLanguage("Other.java", ProgramLanguage.JAVA),
            ),
            workshop.doing.notAllowed,
        )
    }

    @Test
    fun `another world begins a project without the assignment`() {
        val workshop = window()
        workshop.attempt(AnyAssignment.SOLUTION)
        workshop.handle(LearningEvent.WorldChosen("maze"))
        assertNull(workshop.state.assignment)
        assertNull(workshop.project.tries)
        workshop.handle(DocumentEvent.NewRequested)
        assertNull(workshop.state.assignment)
        assertEquals(1, workshop.projects().count { it.project?.tries?.tries == 1 })
    }

    @Test
    fun `a second copy of it offers to go on where the pupil was`() {
        val workshop = window()
        workshop.attempt("forward 5\n")
        workshop.keep()
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyAssignment.file(pupils, "circle (1).robotran"))))
        assertEquals(0, workshop.doing.tries.tries)
        assertIs<Notice.AssignmentBegunBefore>(workshop.state.notice)
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(1, workshop.doing.tries.tries)
        assertEquals("forward 5\n", workshop.state.programText)
        assertEquals(1, workshop.projects().size)
    }

    @Test
    fun `the same file opened a second time asks, and whoever begins anew can still go on`() {
        val workshop = window()
        workshop.attempt("forward 5\n")
        workshop.keep()
        val again = DocumentEvent.FilesBrought(listOf(AnyAssignment.file(pupils)))
        workshop.handle(again)
        assertIs<DocumentDialog.NewerInMyWork>(workshop.state.document.dialog)
        workshop.handle(DocumentEvent.WorkOrFileChosen(isWork = true))
        assertEquals("forward 5\n", workshop.state.programText)
        workshop.handle(again)
        workshop.handle(DocumentEvent.WorkOrFileChosen(isWork = false))
        assertEquals(0, workshop.doing.tries.tries)
        assertIs<Notice.AssignmentBegunBefore>(workshop.state.notice)
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(1, workshop.doing.tries.tries)
        assertEquals("forward 5\n", workshop.state.programText)
        assertEquals(1, workshop.projects().size)
    }

    @Test
    fun `a try of the author's does not count`() {
        val workshop = window(AnyAssignment.teachers)
        workshop.attempt(AnyAssignment.SOLUTION)
        assertTrue(workshop.doing.isAuthor)
        assertNull(workshop.project.tries)
    }

    @Test
    fun `an author's ordinary link has no solution either`() {
        val workshop = window(AnyAssignment.teachers)
        workshop.handle(DocumentEvent.LinkRequested)
        workshop.handle(DocumentEvent.LinkCopied)
        val opened = machine.window()
        opened.handle(DocumentEvent.LinkOpened(checkNotNull(machine.clipboard.text)))
        assertEquals(pupils.assignment?.id, opened.doing.assignment.id)
        assertNull(opened.doing.assignment.checks)
        assertEquals(emptyList(), opened.doing.assignment.solution)
    }
}
