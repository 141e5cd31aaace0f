package robotran.workshop.assignment

import kotlinx.coroutines.runBlocking
import robotran.assignments.doing.NotAllowed
import robotran.assignments.doing.isIntact
import robotran.assignments.doing.pupilCopy
import robotran.language.Language
import robotran.projects.Feedback
import robotran.projects.FeedbackResult
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.openHandInLink
import robotran.projects.readProject
import robotran.workshop.Workshop
import robotran.workshop.documents.Machine
import robotran.workshop.documents.keep
import robotran.workshop.documents.projects
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.state.HandInStep
import robotran.workshop.state.LinkError
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class HandInTest {
    private val machine = Machine().apply { files.location = "/home/hand-in.robotran" }

    private fun window(): Workshop = machine.window(AnyAssignment.request(pupilCopy(AnyAssignment.teachers)))

    private fun Workshop.attempt(text: String) {
        handle(ProgramEvent.ProgramEdited(text))
        handle(RunEvent.RunPressed)
        advance(20_000)
    }

    private val Workshop.asking: HandInStep.Asking get() = assertIs(state.handIn)

    private fun Workshop.handIn(name: String, isEditor: Boolean = false): HandInStep.Ready {
        handle(AssignmentEvent.HandInRequested)
        handle(AssignmentEvent.NameEntered(name))
        if (isEditor) handle(AssignmentEvent.WorkChosen(isEditor = true))
        handle(AssignmentEvent.HandInMade())
        return assertIs(state.handIn)
    }

    private fun saved(): Project =
        assertIs<ProjectFileResult.Success>(readProject(machine.files.disk.values.last(), Language.ENGLISH)).project

    @Test
    fun `the best try is handed in as a file with name, result and intact hash`() {
        val workshop = window()
        workshop.attempt(AnyAssignment.SOLUTION)
        workshop.attempt("forward 5\n")
        workshop.handIn(" Ada \n 7b ")
        workshop.handle(AssignmentEvent.HandInFileSaved)
        val handIn = saved()
        assertEquals("Ada   7b", handIn.handIn?.name)
        assertEquals(2, handIn.handIn?.tries)
        assertEquals(AnyAssignment.SOLUTION, handIn.robots.single().programs.single().files.single().text)
        assertTrue(checkNotNull(handIn.handIn?.result).isSolved)
        assertTrue(isIntact(handIn))
        assertNull(handIn.tries)
        assertEquals("", handIn.assignment?.text)
        assertEquals("Ada   7b", workshop.state.assignment?.handedInAs)
    }

    @Test
    fun `the program in the editor can be handed in instead, after a run that nobody sees`() {
        val workshop = window()
        workshop.attempt("forward 5\n")
        workshop.handle(ProgramEvent.ProgramEdited(AnyAssignment.SOLUTION))
        val ready = workshop.handIn("Ada", isEditor = true)
        assertTrue(checkNotNull(ready.result).isSolved)
        assertEquals(1, workshop.state.assignment?.tries?.tries)
        workshop.handle(AssignmentEvent.HandInFileSaved)
        assertEquals(AnyAssignment.SOLUTION, saved().robots.single().programs.single().files.single().text)
        assertEquals(2, saved().inputs.size)
    }

    @Test
    fun `without a try it is the program in the editor, and there is nothing to choose`() {
        val workshop = window()
        workshop.handle(AssignmentEvent.HandInRequested)
        assertNull(workshop.asking.best)
        assertTrue(workshop.asking.isEditor)
        assertFalse(workshop.asking.canChoose)
        assertEquals("First name and class", workshop.asking.wanted)
    }

    @Test
    fun `what is not allowed is told of the program that is handed in`() {
        val strict = AnyAssignment.teachers.run { copy(assignment = assignment?.copy(words = listOf("forward"))) }
        val workshop = machine.window(AnyAssignment.request(pupilCopy(strict)))
        workshop.attempt("forward 5\nbeep\n")
        workshop.handle(ProgramEvent.ProgramEdited("forward 5\n"))
        workshop.handle(AssignmentEvent.HandInRequested)
        assertEquals(listOf("beep"), workshop.asking.notAllowed.map { (it as NotAllowed.HasWord).word })
        workshop.handle(AssignmentEvent.WorkChosen(isEditor = true))
        assertEquals(emptyList(), workshop.asking.notAllowed)
    }

    @Test
    fun `nothing of a pupil's work is lost by reloading, handing in, going on and opening the feedback`() {
        window().apply {
            attempt("forward 5\n")
            handIn("Ada")
            handle(AssignmentEvent.HandInFileSaved)
            handle(AssignmentEvent.HandInClosed)
            handle(ProgramEvent.ProgramEdited("forward 7\n"))
            runBlocking { assertTrue(closeDocument()) }
        }
        val workshop = machine.window()
        assertEquals("forward 7\n", workshop.state.programText)
        val feedback = saved().copy(feedback = Feedback("Go on."))
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyAssignment.file(feedback, "feedback.robotran"))))
        assertEquals("Go on.", workshop.state.assignment?.feedback?.comment)
        workshop.keep()
        val own = workshop.projects().single { it.project?.tries != null }
        workshop.handle(DocumentEvent.SavedProjectChosen(own.entry.id))
        assertEquals("forward 7\n", workshop.state.programText)
        assertEquals(1, workshop.state.assignment?.tries?.tries)
        assertEquals("Ada", workshop.state.assignment?.handedInAs)
        workshop.handle(AssignmentEvent.HandInRequested)
        assertEquals("Ada", workshop.asking.name)
        assertTrue(workshop.asking.canChoose)
    }

    @Test
    fun `feedback for who has handed in nothing does not say that the program was handed in`() {
        val answer = Feedback("The folder is empty.")
        val nothing = pupilCopy(AnyAssignment.teachers).copy(robots = emptyList(), feedback = answer)
        val workshop = window()
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyAssignment.file(nothing, "feedback.robotran"))))
        assertEquals(false, workshop.state.assignment?.isProgramHandedIn)
        val graded = nothing.copy(feedback = Feedback("Go on.", listOf(FeedbackResult("", 1, 2))))
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyAssignment.file(graded, "graded.robotran"))))
        assertEquals(true, workshop.state.assignment?.isProgramHandedIn)
    }

    @Test
    fun `a program with mistakes is told, and can be handed in without a result`() {
        val workshop = window()
        workshop.handle(ProgramEvent.ProgramEdited("forwrad 5\n"))
        workshop.handle(AssignmentEvent.HandInRequested)
        workshop.handle(AssignmentEvent.NameEntered("Ada"))
        workshop.handle(AssignmentEvent.HandInMade())
        assertTrue(assertIs<HandInStep.HasErrors>(workshop.state.handIn).reasons.isNotEmpty())
        workshop.handle(AssignmentEvent.HandInMade(withErrors = true))
        assertNull(assertIs<HandInStep.Ready>(workshop.state.handIn).result)
    }

    @Test
    fun `nobody hands in without a name, and the name is remembered`() {
        val workshop = window()
        workshop.attempt(AnyAssignment.SOLUTION)
        workshop.handle(AssignmentEvent.HandInRequested)
        workshop.handle(AssignmentEvent.NameEntered("  "))
        workshop.handle(AssignmentEvent.HandInMade())
        assertIs<HandInStep.Asking>(workshop.state.handIn)
        workshop.handle(AssignmentEvent.HandInClosed)
        workshop.handIn("Ada")
        workshop.handle(AssignmentEvent.HandInLinkCopied)
        workshop.handle(AssignmentEvent.HandInClosed)
        workshop.handle(AssignmentEvent.HandInRequested)
        assertEquals("Ada", workshop.asking.name)
        val other = window()
        other.handle(AssignmentEvent.HandInRequested)
        assertEquals("Ada", other.asking.name)
        assertEquals("Ada", other.state.assignment?.handedInAs)
    }

    @Test
    fun `the link is a hand-in that fits its assignment`() {
        val workshop = window()
        workshop.attempt(AnyAssignment.SOLUTION)
        val link = assertNotNull(workshop.handIn("Ada").link)
        val opened = runBlocking { openHandInLink(link, AnyAssignment.world, Language.ENGLISH) }
        assertTrue(isIntact(assertIs<LinkResult.OfProject>(opened).project))
    }

    @Test
    fun `without an address there is a file but no link`() {
        machine.page = ""
        val workshop = window()
        workshop.attempt(AnyAssignment.SOLUTION)
        assertEquals(LinkError.NoSite, workshop.handIn("Ada").linkError)
    }

    @Test
    fun `a hand-in that is opened counts no tries`() {
        val workshop = window()
        workshop.attempt(AnyAssignment.SOLUTION)
        workshop.handIn("Ada")
        workshop.handle(AssignmentEvent.HandInFileSaved)
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyAssignment.file(saved(), "ada.robotran"))))
        assertEquals("Ada", workshop.state.assignment?.handIn?.name)
        workshop.attempt("forward 1\n")
        assertNull(workshop.project.tries)
    }
}
