package robotran.workshop.learning

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.learning.Lessons
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.state.TutorialState
import robotran.world.ReadyRobots
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** A step that is about one brick has that, and the steps before and after it have the pupil's. */
class TutorialOfOneBrickTest {
    private val platform = MemoryPlatform()
    private val opened = mutableListOf<Workshop>()

    private fun workshop(): Workshop =
        runBlocking { openWorkshop(platform = platform, welcoming = false).also { opened += it } }

    @AfterTest
    fun close() = opened.forEach { it.close() }

    private val Workshop.tutorial: TutorialState get() = assertNotNull(state.learning.tutorial)
    private val Workshop.brick: BrickKind get() = state.programs.brick

    private fun indexOf(name: String) = Lessons.indexOf(assertNotNull(Lessons.named(name)))

    private fun on(brick: BrickKind): Workshop = workshop().also { it.handle(DocumentEvent.NewWithBrick(brick)) }

    @Test
    fun `who has another robot takes it with the one of the step, and goes on with the own one`() {
        for (brick in BrickKind.entries) {
            val workshop = on(brick)
            workshop.handle(LearningEvent.LessonChosen(indexOf("first-drive")))
            assertEquals(brick, workshop.brick)
            workshop.handle(LearningEvent.StepChosen(indexOf("by-time")))
            assertEquals(BrickKind.MICROBIT, workshop.brick)
            assertEquals(ReadyRobots.CUTEBOT, workshop.state.world.robots.first().description)
            assertTrue(workshop.tutorial.isLoaded)
            assertEquals("by-time", workshop.tutorial.current.name)
            workshop.handle(LearningEvent.StepChosen(indexOf("first-drive")))
            assertEquals(brick, workshop.brick)
            workshop.handle(LearningEvent.StepChosen(indexOf("echo")))
            workshop.handle(LearningEvent.TutorialClosed)
            assertEquals(brick, workshop.brick)
        }
    }

    @Test
    fun `a robot that lacks a step goes on with the next one that it has`() {
        val workshop = on(BrickKind.SPIKE_ESSENTIAL)
        workshop.handle(LearningEvent.LessonChosen(indexOf("edge")))
        assertEquals(BrickKind.RCX, workshop.brick)
        workshop.handle(LearningEvent.StepChosen(indexOf("counting")))
        assertEquals(BrickKind.SPIKE_ESSENTIAL, workshop.brick)
    }

    @Test
    fun `it is done, saved and found again after the app was closed`() {
        val workshop = on(BrickKind.NXT)
        workshop.handle(LearningEvent.LessonChosen(indexOf("by-time")))
        assertContains(workshop.state.programText, "wait 1 second")
        workshop.handle(ProgramEvent.ProgramEdited(workshop.tutorial.current.solution.text))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(20_000)
        assertTrue(workshop.state.learning.isStepDone)
        assertNotNull(workshop.state.learning.solved?.learned)
        runBlocking { workshop.closeDocument() }
        val again = workshop()
        assertTrue(again.tutorial.isLoaded)
        assertEquals("by-time", again.tutorial.current.name)
        assertContains(again.state.programText, "wait 3.5 seconds")
        assertContains(again.state.learning.stepsDone, "by-time")
        again.handle(LearningEvent.StepChosen(indexOf("first-drive")))
        assertEquals(BrickKind.NXT, again.brick)
    }
}
