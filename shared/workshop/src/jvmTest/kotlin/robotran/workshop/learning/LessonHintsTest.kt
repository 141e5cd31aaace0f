package robotran.workshop.learning

import kotlinx.coroutines.runBlocking
import robotran.learning.HintStage
import robotran.learning.Lessons
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.state.LearningPage
import robotran.workshop.state.TutorialState
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class LessonHintsTest {
    private val platform = MemoryPlatform()
    private val opened = mutableListOf<Workshop>()

    private fun workshop(): Workshop = runBlocking { openWorkshop(platform = platform).also { opened += it } }

    private val Workshop.tutorial: TutorialState get() = assertNotNull(state.learning.tutorial)
    private val Workshop.conditions get() = tutorial.hints.map { it.condition?.phrase }

    private fun Workshop.tries(program: String) {
        handle(ProgramEvent.ProgramEdited(program))
        handle(RunEvent.RunPressed)
        advance(15_000)
    }

    private fun lesson(name: String) = Lessons.all.indexOfFirst { it.name == name }

    @AfterTest
    fun close() = opened.forEach { it.close() }

    @Test
    fun `after a try that failed, the hint that fits it is there`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.LessonChosen(lesson("repeat")))
        workshop.tries("pen down\nrepeat 6 times\n  forward 20\n  turn right 60\nend\npen up\n")
        assertEquals(listOf("turned the wrong way"), workshop.conditions)
        assertEquals(4, workshop.tutorial.hints.single().line)
        workshop.tries("pen down\nrepeat 5 times\n  forward 20\n  turn left 60\nend\npen up\n")
        assertEquals(listOf("one too few"), workshop.conditions)
    }

    @Test
    fun `each touch shows one more hint, down to the solution in words, and then hides all`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.TutorialStarted)
        for (stage in HintStage.entries) {
            assertEquals(stage, workshop.tutorial.nextStage)
            workshop.handle(LearningEvent.HintRequested(true))
            assertEquals(stage, workshop.tutorial.hints.last().stage)
        }
        assertNull(workshop.tutorial.nextStage)
        workshop.handle(LearningEvent.HintRequested(false))
        assertTrue(workshop.tutorial.hints.isEmpty())
    }

    @Test
    fun `hidden hints begin again with the one that fits, and a solved task needs none`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.tries("forward 30\nturn right 90\nforward 25\n")
        workshop.handle(LearningEvent.HintRequested(true))
        assertEquals(listOf("turned the wrong way", null), workshop.conditions)
        workshop.handle(LearningEvent.HintRequested(false))
        workshop.handle(LearningEvent.HintRequested(true))
        assertEquals(listOf("turned the wrong way"), workshop.conditions)
        workshop.tries(Lessons.all[0].solution.text)
        assertTrue(workshop.tutorial.hints.isEmpty())
    }

    @Test
    fun `show me runs the solution and the pupil's program comes back`() {
        val workshop = workshop()
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(ProgramEvent.ProgramEdited("forward 1\n"))
        workshop.handle(LearningEvent.SolutionRequested(true))
        workshop.advance(1000)
        assertTrue(workshop.state.running)
        workshop.advance(8000)
        assertFalse(workshop.state.learning.isStepDone)
        assertTrue(workshop.tutorial.hints.isEmpty())
        workshop.handle(LearningEvent.SolutionRequested(false))
        assertEquals("forward 1\n", workshop.state.programText)
    }

    @Test
    fun `a lesson of the map opens in its own world, with what was written there`() {
        val workshop = workshop()
        workshop.handle(ProgramEvent.ProgramEdited("forward 9\n"))
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        workshop.handle(LearningEvent.LessonChosen(lesson("star")))
        assertNull(workshop.state.learning.page)
        assertTrue(workshop.tutorial.isLoaded)
        assertEquals(Lessons.all[lesson("star")].program.text, workshop.state.programText)
        workshop.handle(ProgramEvent.ProgramEdited("forward 2\n"))
        workshop.handle(LearningEvent.LessonChosen(lesson("house")))
        workshop.handle(LearningEvent.LessonChosen(lesson("star")))
        assertEquals("forward 2\n", workshop.state.programText)
        workshop.handle(LearningEvent.TutorialClosed)
        assertEquals("forward 9\n", workshop.state.programText)
    }

    @Test
    fun `progress of the ten steps of older versions is kept`() {
        runBlocking {
            platform.store.write(
                "learning",
                """{"step": "08-own-commands", "stepsDone": ["01-first-drive", "03-repeat"],
                    "programs": {"03-repeat": "forward 3\n"}, "tutorialShown": true}""",
            )
        }
        val workshop = workshop()
        assertEquals(setOf("first-drive", "repeat"), workshop.state.learning.stepsDone)
        assertEquals("own-commands", workshop.tutorial.current.name)
        workshop.handle(LearningEvent.LessonChosen(lesson("repeat")))
        assertEquals("forward 3\n", workshop.state.programText)
    }

    @Test
    fun `the next lesson is the first that is not done`() {
        val workshop = workshop()
        assertEquals(0, workshop.state.learning.nextLesson)
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.tries(Lessons.all[0].solution.text)
        assertEquals(1, workshop.state.learning.nextLesson)
    }
}
