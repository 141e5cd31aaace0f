package robotran.workshop.learning

import kotlinx.coroutines.runBlocking
import robotran.learning.Lessons
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.sound.RecordingSpeaker
import robotran.workshop.state.SolvedTask
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull

class SolvedTaskTest {
    private val speaker = RecordingSpeaker()
    private val workshop = runBlocking { openWorkshop(platform = MemoryPlatform(speaker)) }

    private val solution get() = checkNotNull(workshop.state.learning.tutorial).current.solution.text

    @AfterTest
    fun close() = workshop.close()

    private fun Workshop.solve(text: String): SolvedTask? {
        handle(ProgramEvent.ProgramEdited(text))
        handle(RunEvent.RunPressed)
        advance(30_000)
        return state.learning.solved
    }

    @Test
    fun `a solved step says what was learned, its figures and the next step`() {
        workshop.handle(LearningEvent.TutorialStarted)
        val solved = assertNotNull(workshop.solve(solution))
        val step = checkNotNull(workshop.state.learning.tutorial).current
        assertEquals(step.text(workshop.language).skill, solved.learned)
        assertEquals(workshop.state.run.outcome.finished, solved.milliseconds)
        assertEquals(1, solved.nextStep)
        assertNull(solved.bestMilliseconds)
    }

    @Test
    fun `the pupil's own best time and length are kept and compared, lines without comments`() {
        workshop.handle(LearningEvent.TutorialStarted)
        val first = assertNotNull(workshop.solve("wait 2 seconds\n$solution"))
        val second = assertNotNull(workshop.solve("// A note.\n\n$solution"))
        assertEquals(first.milliseconds, second.bestMilliseconds)
        assertEquals(first.lines, second.bestLines)
        assertEquals(first.lines - 1, second.lines)
        val third = assertNotNull(workshop.solve("wait 1 second\n$solution"))
        assertEquals(second.milliseconds to second.lines, third.bestMilliseconds to third.bestLines)
    }

    @Test
    fun `what the robot drew in a solved lesson is kept, the latest, but not what the solution draws`() {
        workshop.handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == "pen" }))
        workshop.handle(LearningEvent.SolutionRequested(true))
        workshop.advance(30_000)
        assertNull(workshop.state.learning.drawings["pen"])
        workshop.handle(LearningEvent.SolutionRequested(false))
        workshop.solve(solution)
        val first = assertNotNull(workshop.state.learning.drawings["pen"])
        assertEquals(workshop.state.session.ink.strokes.size, first.lines.size)
        workshop.solve("$solution\nforward 5")
        assertNotNull(workshop.state.learning.solved)
        assertNotEquals(first, workshop.state.learning.drawings["pen"])
    }

    @Test
    fun `a new run takes the praise away`() {
        workshop.handle(LearningEvent.TutorialStarted)
        assertNotNull(workshop.solve(solution))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(100)
        assertNull(workshop.state.learning.solved)
    }

    @Test
    fun `a solved task has a tune, unless the sound is off or motion is reduced`() {
        workshop.handle(LearningEvent.TutorialStarted)
        val solution = solution
        for (settings in listOf(
            workshop.settings.copy(soundOn = false),
            workshop.settings.copy(soundOn = true, lessMotion = true),
            workshop.settings.copy(soundOn = true, lessMotion = false),
        )) {
            workshop.handle(SettingsEvent.SettingsChanged(settings))
            speaker.tones.clear()
            workshop.solve(solution)
            val hasTune = settings.soundOn && settings.lessMotion == false
            assertEquals(if (hasTune) 4 else 0, speaker.tones.size, "$settings")
        }
    }

    @Test
    fun `the solution that is shown solves nothing`() {
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(LearningEvent.SolutionRequested(true))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(30_000)
        assertNull(workshop.state.learning.solved)
    }
}
