package robotran.workshop.learning

import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.documents.StoreResult
import robotran.language.ProgramLanguage
import robotran.learning.Lessons
import robotran.learning.WorldGallery
import robotran.projects.ProgramView
import robotran.workshop.Workshop
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.MemoryStore
import robotran.workshop.state.LearningPage
import robotran.workshop.state.LearningState
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class LearningStateHolderTest {
    private val platform = MemoryPlatform()
    private val opened = mutableListOf<Workshop>()

    private fun workshop(welcoming: Boolean = false): Workshop = runBlocking {
        openWorkshop(platform = platform, welcoming = welcoming).also { opened += it }
    }

    private val Workshop.learning: LearningState get() = state.learning

    private fun Workshop.edit(text: String) = handle(ProgramEvent.ProgramEdited(text))

    @AfterTest
    fun close() = opened.forEach { it.close() }

    @Test
    fun `the first page is shown on the first start and never again`() {
        val first = workshop(welcoming = true)
        assertEquals(LearningPage.FIRST_RUN, first.learning.page)
        first.handle(LearningEvent.PageClosed)
        assertNull(first.learning.page)
        assertNull(workshop(welcoming = true).learning.page)
    }

    @Test
    fun `a new project from the menu of the window leaves whatever page covers it`() {
        val workshop = workshop(welcoming = true)
        workshop.handle(DocumentEvent.NewWithBrick(BrickKind.NXT))
        assertNull(workshop.learning.page)
        assertNull(workshop(welcoming = true).learning.page, "who has begun is not welcomed again")
        workshop.handle(SettingsEvent.SettingsShown(true))
        workshop.handle(DocumentEvent.NewRequested)
        assertFalse(workshop.state.settingsShown)
    }

    @Test
    fun `who comes with a program is not welcomed`() {
        assertNull(workshop(welcoming = false).learning.page)
    }

    @Test
    fun `progress that cannot be read is no progress`() {
        runBlocking { platform.store.write("learning", "{ nonsense") }
        assertEquals(LearningPage.FIRST_RUN, workshop(welcoming = true).learning.page)
    }

    @Test
    fun `the square runs at a touch, and is not put there twice`() {
        val workshop = workshop(welcoming = true)
        workshop.handle(LearningEvent.FirstProgramTried)
        workshop.advance(1500)
        assertTrue(workshop.state.running)
        assertNull(workshop.learning.page)
        assertEquals(listOf("square.robo"), workshop.state.programs.programs.map { it.name })
    }

    @Test
    fun `who has run the square is invited to change a number of it`() {
        val workshop = workshop(welcoming = true)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        workshop.handle(LearningEvent.FirstProgramTried)
        assertEquals(Notice.FirstProgramRuns, workshop.state.notice)
        workshop.handle(WorkshopEvent.NoticeTaken)
        val blocks = checkNotNull(workshop.state.programs.blocks)
        val sheet = blocks.sheet as BlockDialog.Part
        assertEquals("20", sheet.span.textIn(blocks.program.text))
        assertEquals(Pane.PROGRAM, workshop.state.pane)
        workshop.handle(BlockEvent.Put("30"))
        assertTrue("forward 30" in workshop.state.programText)
    }

    @Test
    fun `the invitation goes once the program is changed`() {
        val workshop = workshop(welcoming = true)
        workshop.handle(LearningEvent.FirstProgramTried)
        workshop.edit("forward 7\n")
        assertNull(workshop.state.notice)
    }

    @Test
    fun `the tutorial comes onto the desk and the pupil's own work comes back`() {
        val workshop = workshop(welcoming = true)
        workshop.edit("forward 7\n")
        workshop.handle(LearningEvent.TutorialStarted)
        val step = Lessons.all.first()
        assertEquals(step.program.text, workshop.state.programText)
        assertEquals(step.text(workshop.learning.language).title, workshop.state.world.title)
        assertTrue(assertNotNull(workshop.learning.tutorial).isLoaded)
        workshop.handle(LearningEvent.TutorialClosed)
        assertEquals("forward 7\n", workshop.state.programText)
        assertNull(workshop.learning.tutorial)
    }

    @Test
    fun `work that was never changed is empty again after the tutorial`() {
        val workshop = workshop()
        val before = workshop.state.programText
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(LearningEvent.TutorialClosed)
        assertEquals(before, workshop.state.programText)
        assertNull(workshop.learning.tutorial)
    }

    @Test
    fun `a page that is opened while the tutorial is still being left stays open`() {
        val store = HeldStore()
        val workshop = runBlocking { openWorkshop(platform = MemoryPlatform(store = store)) }.also { opened += it }
        val before = workshop.state.programText
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.edit("forward 31\n")
        store.held = CompletableDeferred()
        workshop.handle(LearningEvent.TutorialClosed)
        assertEquals("forward 31\n", workshop.state.programText, "the store is not done yet")
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        store.held?.complete(Unit)
        assertEquals(before, workshop.state.programText)
        assertEquals(LearningPage.WORLDS, workshop.learning.page)
    }

    /** A store that writes only when [held] is over. */
    private class HeldStore(private val memory: MemoryStore = MemoryStore()) : KeyValueStore by memory {
        var held: CompletableDeferred<Unit>? = null

        override suspend fun write(name: String, text: String): StoreResult {
            held?.await()
            return memory.write(name, text)
        }
    }

    @Test
    fun `reading the tutorial alone changes nothing on the desk`() {
        val workshop = workshop()
        val before = workshop.state.programText
        workshop.handle(LearningEvent.PageRequested(LearningPage.TUTORIAL))
        workshop.handle(LearningEvent.StepChosen(4))
        assertEquals(before, workshop.state.programText)
        assertEquals(4, workshop.learning.tutorial?.step)
        assertFalse(assertNotNull(workshop.learning.tutorial).isLoaded)
    }

    @Test
    fun `what is written in a step is there again when the pupil comes back to it`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.edit("forward 30\n")
        workshop.handle(LearningEvent.StepChosen(1))
        assertEquals(Lessons.all[1].program.text, workshop.state.programText)
        workshop.handle(LearningEvent.StepChosen(0))
        assertEquals("forward 30\n", workshop.state.programText)
        workshop.handle(LearningEvent.TutorialClosed)
        workshop.handle(LearningEvent.TutorialStarted)
        assertEquals("forward 30\n", workshop.state.programText)
        workshop.handle(LearningEvent.StepRestarted)
        assertEquals(Lessons.all[0].program.text, workshop.state.programText)
    }

    @Test
    fun `the solution can be looked at, and the pupil's program comes back`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.edit("forward 1\n")
        workshop.handle(LearningEvent.SolutionRequested(true))
        assertEquals(Lessons.all[0].solution.text, workshop.state.programText)
        workshop.handle(LearningEvent.SolutionRequested(false))
        assertEquals("forward 1\n", workshop.state.programText)
        workshop.handle(LearningEvent.SolutionRequested(true))
        workshop.handle(LearningEvent.StepChosen(1))
        workshop.handle(LearningEvent.StepChosen(0))
        assertEquals("forward 1\n", workshop.state.programText)
    }

    @Test
    fun `a task is done when the run has met its goals, and stays done`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(4000)
        assertFalse(workshop.learning.isStepDone)
        workshop.edit(Lessons.all[0].solution.text)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(3500)
        assertFalse(workshop.learning.isStepDone, "it may still drive on")
        workshop.advance(2500)
        assertTrue(workshop.learning.isStepDone)
        val again = workshop()
        assertEquals(setOf(Lessons.all[0].name), again.learning.stepsDone)
        assertEquals(0, again.learning.tutorial?.step)
    }

    @Test
    fun `watching the solution does not do the task`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(LearningEvent.SolutionRequested(true))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(4000)
        assertFalse(workshop.learning.isStepDone)
    }

    @Test
    fun `drawings are judged when the program is over`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(LearningEvent.StepChosen(1))
        workshop.edit(Lessons.all[1].solution.text)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(8000)
        assertTrue(workshop.learning.isStepDone)
    }

    @Test
    fun `a world of the gallery comes onto the desk with the programs there are`() {
        val workshop = workshop()
        workshop.edit("pen down\nforward 50\n")
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        workshop.handle(LearningEvent.WorldChosen("maze"))
        assertNull(workshop.learning.page)
        assertEquals(WorldGallery.named("maze")?.world(workshop.learning.language), workshop.state.world)
        assertEquals("pen down\nforward 50\n", workshop.state.programText)
    }

    @Test
    fun `a world chosen from within the tutorial is for the pupil's own programs`() {
        val workshop = workshop()
        workshop.edit("forward 9\n")
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(LearningEvent.WorldChosen("square"))
        assertEquals("forward 9\n", workshop.state.programText)
        assertEquals("square", WorldGallery.find(workshop.state.world)?.name)
    }

    @Test
    fun `a world whose goals are met is marked and told`() {
        val workshop = workshop()
        workshop.edit("pen down\nforward 41\n")
        workshop.handle(LearningEvent.WorldChosen("plain"))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(5000)
        assertEquals(setOf("plain"), workshop.learning.worldsDone)
        assertNotNull(workshop.state.notice)
        assertEquals(setOf("plain"), workshop().learning.worldsDone)
    }

    @Test
    fun `help is found on the word in the program, in either language`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.HelpRequested("turn left 90", 6))
        assertEquals("left", workshop.learning.help.found?.word)
        workshop.handle(LearningEvent.HelpRequested("class A {\n  Motor.A.forward();\n}", 22))
        assertEquals(ProgramLanguage.JAVA, workshop.learning.help.programLanguage)
        assertEquals("Motor.forward", workshop.learning.help.found?.word)
        workshop.handle(LearningEvent.HelpRequested("var side = 3", 5))
        assertEquals("side", workshop.learning.help.word)
        assertNull(workshop.learning.help.found)
    }

    @Test
    fun `the example of a word goes into a tab of its own, once`() {
        val workshop = workshop()
        repeat(2) {
            workshop.handle(LearningEvent.HelpRequested("repeat", 1))
            workshop.handle(LearningEvent.ExampleTried)
        }
        assertEquals(listOf("square.robo", "try.robo"), workshop.state.programs.programs.map { it.name })
        assertEquals(workshop.learning.help.found?.example, workshop.state.programText)
        assertNull(workshop.learning.page)
    }

    @Test
    fun `where the brick is full there is no room for an example, and that is said`() {
        val workshop = workshop()
        repeat(4) { workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.ROBOLANG)) }
        workshop.handle(LearningEvent.HelpRequested("repeat", 1))
        workshop.handle(LearningEvent.ExampleTried)
        assertEquals(5, workshop.state.programs.programs.size)
        assertNotNull(workshop.state.notice)
        assertEquals(LearningPage.HELP, workshop.learning.page)
    }
}
