package robotran.workshop

import kotlinx.coroutines.runBlocking
import robotran.programs.Program
import robotran.runcontrol.RunSpeed
import robotran.runsound.SoundSample
import robotran.runsound.Timbre
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.sound.PlannedTone
import robotran.workshop.sound.RecordingSpeaker
import robotran.workshop.state.Notice
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class HeardRunTest {
    private val speaker = RecordingSpeaker()
    private val workshop =
        runBlocking {
            openWorkshop(
                listOf(Program.of("drive.robo", "forward 20\nbeep\nturn left 90\nforward 10")),
                MemoryPlatform(speaker),
            )
        }
    private var nanoseconds = 0L

    @AfterTest
    fun close() = workshop.close()

    private fun watch(milliseconds: Int) {
        repeat(milliseconds / FRAME) {
            nanoseconds += FRAME * 1_000_000L
            speaker.milliseconds += FRAME
            workshop.frame(nanoseconds)
        }
    }

    /** What is heard of a run in [milliseconds]. */
    private fun run(milliseconds: Int = 4_000): List<PlannedTone> {
        watch(1_000)
        speaker.tones.clear()
        workshop.handle(RunEvent.RunPressed)
        watch(milliseconds)
        return speaker.tones.toList()
    }

    private val List<PlannedTone>.ofRun get() = filter { it.pan != 0.0 || it.timbre != Timbre.SQUARE }

    @Test
    fun `at first nothing is heard of a run but its brick`() {
        assertEquals(emptyList(), run().ofRun)
    }

    @Test
    fun `when it is switched on, wheels, distances and the end are heard, and the brick as before`() {
        val before = run().map { it.hertz to it.duration }.toSet()
        workshop.handle(RunEvent.HearingSwitched)
        assertEquals(Notice.RunHeard(on = true, isMuted = false), workshop.state.notice)
        val tones = run()
        assertTrue(tones.ofRun.size > 10, "$tones")
        assertTrue(tones.map { it.hertz to it.duration }.toSet().containsAll(before))
    }

    @Test
    fun `the same key switches it off again`() {
        repeat(2) { workshop.handle(RunEvent.HearingSwitched) }
        assertEquals(Notice.RunHeard(on = false, isMuted = false), workshop.state.notice)
        assertEquals(emptyList(), run().ofRun)
    }

    @Test
    fun `the switch of all sound holds for it, too`() {
        workshop.handle(SettingsEvent.SoundSwitched(on = false))
        workshop.handle(RunEvent.HearingSwitched)
        assertEquals(Notice.RunHeard(on = true, isMuted = true), workshop.state.notice)
        workshop.handle(RunEvent.SampleRequested(SoundSample.GOAL))
        assertEquals(emptyList(), run())
    }

    @Test
    fun `the same run sounds the same again, also in its known past`() {
        workshop.handle(RunEvent.HearingSwitched)
        val first = run().map { it.copy(start = 0.0) }
        val again = run().map { it.copy(start = 0.0) }
        assertEquals(first, again)
        workshop.handle(RunEvent.Scrubbed(0))
        watch(500)
        speaker.tones.clear()
        workshop.handle(RunEvent.PausePressed)
        watch(4_000)
        assertEquals(first.ofRun, speaker.tones.map { it.copy(start = 0.0) }.ofRun)
    }

    @Test
    fun `scrubbing sounds where the slider stands, one moment at a time`() {
        workshop.handle(RunEvent.HearingSwitched)
        run()
        speaker.tones.clear()
        workshop.handle(RunEvent.Scrubbed(900))
        workshop.handle(RunEvent.Scrubbed(910))
        assertEquals(1, speaker.tones.size)
        speaker.milliseconds += 100
        workshop.handle(RunEvent.Scrubbed(1_400))
        assertEquals(2, speaker.tones.size)
    }

    @Test
    fun `without the setting scrubbing is silent`() {
        run()
        speaker.tones.clear()
        workshop.handle(RunEvent.Scrubbed(900))
        assertEquals(emptyList(), speaker.tones)
    }

    @Test
    fun `as fast as it goes nothing is heard`() {
        workshop.handle(RunEvent.HearingSwitched)
        workshop.handle(RunEvent.SpeedChosen(RunSpeed.FASTEST))
        assertEquals(emptyList(), run().ofRun)
    }

    @Test
    fun `each sound can be listened to alone`() {
        for (sample in SoundSample.entries) {
            speaker.tones.clear()
            workshop.handle(RunEvent.SampleRequested(sample))
            assertEquals(sample.tones.map { it.hertz }, speaker.tones.map { it.hertz }, "$sample")
        }
    }

    private companion object {
        const val FRAME = 20
    }
}
