package robotran.workshop.learning

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.learning.LessonPlace
import robotran.learning.Lessons
import robotran.learning.hint.HintCondition
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.sound.RecordingSpeaker
import robotran.workshop.state.LearningState
import robotran.workshop.state.WorkshopStatus
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** A lesson is done once the same program has reached the goals in both of its places. */
class LessonTriedAgainTest {
    private val platform = MemoryPlatform(RecordingSpeaker())
    private val workshop = open()
    private val learning: LearningState get() = workshop.state.learning
    private val tutorial get() = assertNotNull(learning.tutorial)

    @AfterTest
    fun close() = workshop.close()

    private fun open(): Workshop = runBlocking { openWorkshop(platform = platform, welcoming = false) }

    private fun begin(lesson: String) =
        workshop.handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == lesson }))

    private fun write(program: String) = workshop.handle(ProgramEvent.ProgramEdited(program))

    private fun run() {
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(LONG)
    }

    private fun tryThere() {
        workshop.handle(LearningEvent.OtherPlaceTried)
        workshop.advance(LONG)
    }

    @Test
    fun `what reaches the goals here is not praised, but tried there with the same program`() {
        begin("edge")
        write(tutorial.current.solution.text)
        run()
        assertNull(learning.solved)
        assertFalse(learning.isStepDone)
        assertEquals(LessonPlace.AGAIN, learning.elsewhere)
        assertTrue(workshop.state.run.isSolved)
        val time = workshop.state.run.outcome.finished
        tryThere()
        assertEquals(LessonPlace.AGAIN, tutorial.place)
        assertEquals(tutorial.current.solution.text, workshop.state.programText)
        assertNotNull(learning.solved)
        assertTrue(learning.isStepDone)
        assertNull(learning.elsewhere)
        assertEquals(time, learning.solved?.milliseconds, "the best time is that of the lesson's own world")
    }

    @Test
    fun `a way that is known by heart fails there, with the hint about that, and nothing is done`() {
        begin("edge")
        write(BY_HEART)
        run()
        assertEquals(LessonPlace.AGAIN, learning.elsewhere)
        assertEquals(emptyList(), tutorial.hints)
        tryThere()
        assertNull(learning.elsewhere)
        assertNull(learning.solved)
        assertFalse(learning.isStepDone)
        assertEquals(emptyMap(), learning.drawings)
        assertEquals(HintCondition.AGAIN, tutorial.help.fittingHint?.condition?.phrase)
        write("forward 20\nbeep\n")
        run()
        assertEquals("word missing: start", tutorial.help.fittingHint?.condition?.phrase)
    }

    @Test
    fun `two programs that each fit one place do not count together`() {
        begin("edge")
        write(BY_HEART)
        run()
        tryThere()
        write("forward 21\nbeep\n")
        run()
        assertEquals(LessonPlace.FIRST, learning.elsewhere, "what works there is to be tried where the lesson began")
        tryThere()
        assertEquals(LessonPlace.FIRST, tutorial.place)
        assertNull(learning.solved)
        assertEquals(HintCondition.AGAIN, tutorial.help.fittingHint?.condition?.phrase)
        write(tutorial.current.solution.text)
        run()
        assertEquals(LessonPlace.AGAIN, learning.elsewhere)
    }

    @Test
    fun `a program that is changed after its run counts as it was when it ran`() {
        begin("edge")
        write(BY_HEART)
        run()
        write("forward 21\nbeep\n")
        workshop.advance(100)
        tryThere()
        assertEquals(LessonPlace.FIRST, learning.elsewhere)
        assertNull(learning.solved)
    }

    @Test
    fun `whoever fixes it there is led back, and has solved it then, with the drawing of the lesson's own world`() {
        begin("edge")
        write(BY_HEART)
        run()
        tryThere()
        write(tutorial.current.solution.text)
        run()
        assertEquals(LessonPlace.FIRST, learning.elsewhere)
        tryThere()
        assertNotNull(learning.solved)
        val here = learning.drawings["edge"]
        assertNotNull(here)
        run()
        assertNotNull(learning.solved, "it goes on to be solved")
        assertEquals(here, learning.drawings["edge"])
    }

    @Test
    fun `the solution is shown in the world on the sheet, and begins nothing`() {
        begin("edge")
        write(BY_HEART)
        run()
        tryThere()
        workshop.handle(LearningEvent.SolutionRequested(true))
        workshop.advance(LONG)
        assertEquals(LessonPlace.AGAIN, tutorial.place)
        assertTrue(workshop.state.run.isSolved)
        assertNull(learning.solved)
        assertNull(learning.elsewhere)
        workshop.handle(LearningEvent.SolutionRequested(false))
        assertEquals(LessonPlace.AGAIN, tutorial.place)
        assertEquals(BY_HEART, workshop.state.programText)
    }

    @Test
    fun `to begin again, or to come back to the lesson, leads to its first world`() {
        begin("edge")
        val first = workshop.state.world
        for (way in listOf<() -> Unit>(
            { workshop.handle(LearningEvent.StepRestarted) },
            { begin("light").also { begin("edge") } },
            { begin("edge") },
            { workshop.handle(LearningEvent.TutorialClosed).also { workshop.handle(LearningEvent.TutorialStarted) } },
        )) {
            write(BY_HEART)
            run()
            tryThere()
            assertNotEquals(first, workshop.state.world)
            way()
            assertEquals(first, workshop.state.world)
            assertEquals(LessonPlace.FIRST, tutorial.place)
        }
    }

    @Test
    fun `the status says that it works here, not that it is solved`() {
        begin("bumping-along")
        write(tutorial.current.solution.text)
        run()
        assertEquals(WorkshopStatus.SolvedHere, workshop.state.status)
        tryThere()
        assertEquals(WorkshopStatus.Solved, workshop.state.status)
    }

    @Test
    fun `it is the same with an NXT, and in Java`() {
        workshop.handle(DocumentEvent.NewWithBrick(BrickKind.NXT))
        for (lesson in listOf("lighthouse", "java-light")) {
            begin(lesson)
            val step = tutorial.current
            assertEquals(BrickKind.NXT, step.brick)
            write(step.solution.text)
            runBlocking { workshop.compilePrograms() }
            run()
            assertEquals(LessonPlace.AGAIN, learning.elsewhere, lesson)
            tryThere()
            assertNotNull(learning.solved, lesson)
        }
    }

    private companion object {
        const val BY_HEART = "wait 0.1 seconds\nforward 46\nbeep\n"

        /** Longer than the time limits of these lessons. */
        const val LONG = 61_000
    }
}
