package robotran.workshop.learning

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.learning.Lessons
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.state.TutorialState
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** The tutorial follows the brick that the pupil works with. */
class TutorialOnNxtTest {
    private val platform = MemoryPlatform()
    private val opened = mutableListOf<Workshop>()

    private fun workshop(): Workshop =
        runBlocking { openWorkshop(platform = platform, welcoming = false).also { opened += it } }

    @AfterTest
    fun close() = opened.forEach { it.close() }

    private val Workshop.tutorial: TutorialState get() = assertNotNull(state.learning.tutorial)
    private val Workshop.brick: BrickKind get() = state.programs.brick

    private fun indexOf(name: String) = Lessons.indexOf(assertNotNull(Lessons.named(name)))

    private fun onNxt(): Workshop = workshop().also {
        it.handle(DocumentEvent.NewWithBrick(BrickKind.NXT))
        it.handle(LearningEvent.TutorialStarted)
    }

    @Test
    fun `the steps have the brick of the project that the pupil comes from`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.TutorialStarted)
        assertEquals(BrickKind.RCX, workshop.brick)
        workshop.handle(LearningEvent.TutorialClosed)
        workshop.handle(DocumentEvent.NewWithBrick(BrickKind.NXT))
        workshop.handle(LearningEvent.TutorialStarted)
        assertEquals(BrickKind.NXT, workshop.brick)
        assertTrue(workshop.tutorial.isLoaded)
        workshop.handle(LearningEvent.TutorialClosed)
        assertEquals(BrickKind.NXT, workshop.brick)
    }

    @Test
    fun `a step is done with an NXT, and the next one has it, too`() {
        val workshop = onNxt()
        workshop.handle(LearningEvent.SolutionRequested(true))
        workshop.handle(LearningEvent.SolutionRequested(false))
        workshop.handle(ProgramEvent.ProgramEdited(workshop.tutorial.current.solution.text))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(20_000)
        assertTrue(workshop.state.learning.isStepDone)
        assertEquals(1, workshop.state.learning.solved?.nextStep)
        workshop.handle(LearningEvent.StepChosen(1))
        assertEquals(BrickKind.NXT, workshop.brick)
        assertTrue(workshop.tutorial.isLoaded)
    }

    @Test
    fun `the steps in Java are for the brick, also after the app was closed`() {
        val workshop = onNxt()
        workshop.handle(LearningEvent.StepChosen(indexOf("lejos")))
        assertEquals(BrickKind.NXT, workshop.brick)
        runBlocking { workshop.compilePrograms() }
        assertContains(workshop.state.programText, "import lejos.nxt.*;")
        assertEquals(emptyList(), workshop.state.diagnostics)
        runBlocking { workshop.closeDocument() }
        val again = workshop()
        assertTrue(again.tutorial.isLoaded)
        assertEquals(BrickKind.NXT, again.tutorial.brick)
        assertContains(again.tutorial.current.text(Language.ENGLISH).paragraphs.first(), "leJOS NXJ")
        again.handle(LearningEvent.StepChosen(0))
        assertEquals(BrickKind.NXT, again.brick)
    }

    @Test
    fun `the light sensor is on the port of the robot, and each brick has a version of the pupil's program`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.LessonChosen(indexOf("edge")))
        assertContains(workshop.state.programText, "light sensor on 2")
        workshop.handle(ProgramEvent.ProgramEdited("beep // with an RCX\n"))
        workshop.handle(DocumentEvent.NewWithBrick(BrickKind.NXT))
        workshop.handle(LearningEvent.LessonChosen(indexOf("edge")))
        assertContains(workshop.state.programText, "light sensor on 3")
        workshop.handle(ProgramEvent.ProgramEdited("beep // with an NXT\n"))
        workshop.handle(DocumentEvent.NewRequested)
        workshop.handle(LearningEvent.StepTried)
        assertEquals("beep // with an RCX\n", workshop.state.programText)
        workshop.handle(DocumentEvent.NewWithBrick(BrickKind.NXT))
        workshop.handle(LearningEvent.StepTried)
        assertEquals("beep // with an NXT\n", workshop.state.programText)
    }

    @Test
    fun `a step speaks the language that is chosen at once`() {
        val workshop = onNxt()
        workshop.handle(SettingsEvent.SettingsChanged(workshop.settings.copy(language = Language.GERMAN)))
        assertEquals(Language.GERMAN, workshop.state.learning.language)
        assertTrue(workshop.tutorial.isLoaded)
    }

    @Test
    fun `who changes the robot in a step stays in the step`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.LessonChosen(indexOf("edge")))
        for (brick in listOf(BrickKind.NXT, BrickKind.RCX)) {
            workshop.handle(WorldEditEvent.PenbotChosen(workshop.state.programs.shownRobot, brick))
            assertEquals(brick, workshop.brick)
            assertTrue(workshop.tutorial.isLoaded)
            assertEquals(brick, workshop.tutorial.current.brick)
        }
    }
}
