package robotran.workshop

import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.programs.Program
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.sound.RecordingSpeaker
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class WorkshopSoundTest {
    private val speaker = RecordingSpeaker()
    private val workshop =
        runBlocking {
            openWorkshop(
                listOf(Program.of("beep.robo", "beep\nwait 300 milliseconds\nbeep")),
                MemoryPlatform(speaker),
            )
        }
    private var nanoseconds = 0L

    @AfterTest
    fun close() = workshop.close()

    /** Advances the frames and the speaker's clock. */
    private fun watch(milliseconds: Int) {
        repeat(milliseconds / FRAME) {
            nanoseconds += FRAME * 1_000_000L
            speaker.milliseconds += FRAME
            workshop.frame(nanoseconds)
        }
    }

    @Test
    fun `switching the brick on is heard as two beeps`() {
        watch(1_000)
        assertEquals(listOf(1000.0, 1000.0), speaker.tones.map { it.hertz })
        assertEquals(200.0, speaker.tones[1].start - speaker.tones[0].start, absoluteTolerance = 1e-6)
    }

    @Test
    fun `a program's beeps are heard`() {
        watch(1_000)
        speaker.tones.clear()
        workshop.handle(RunEvent.ButtonPressed(BrickButton.RUN))
        workshop.handle(RunEvent.ButtonReleased(BrickButton.RUN))
        watch(2_000)
        assertTrue(speaker.tones.count { it.hertz == 2000.0 } >= 2)
    }

    @Test
    fun `nothing is heard while the sound is off, and what was missed never`() {
        workshop.handle(SettingsEvent.SoundSwitched(on = false))
        assertFalse(workshop.state.soundOn)
        assertEquals(1, speaker.silences)
        watch(1_000)
        workshop.handle(SettingsEvent.SoundSwitched(on = true))
        watch(1_000)
        assertEquals(emptyList(), speaker.tones)
        workshop.handle(RunEvent.ButtonPressed(BrickButton.PRGM))
        watch(200)
        assertEquals(1, speaker.tones.size)
    }

    @Test
    fun `the sound stays off when a run begins afresh`() {
        workshop.handle(SettingsEvent.SoundSwitched(on = false))
        workshop.handle(RunEvent.RunPressed)
        watch(2_000)
        assertFalse(workshop.state.soundOn)
        assertEquals(emptyList(), speaker.tones)
    }

    @Test
    fun `time that passes at once is not heard`() {
        workshop.advance(5_000)
        watch(200)
        assertEquals(emptyList(), speaker.tones)
    }

    @Test
    fun `a run that begins afresh silences the one before`() {
        watch(100)
        workshop.handle(RunEvent.RunPressed)
        assertEquals(1, speaker.silences)
    }

    @Test
    fun `a workshop that closes closes its speaker`() {
        workshop.close()
        assertTrue(speaker.closed)
    }

    private companion object {
        /** Milliseconds. */
        const val FRAME = 16
    }
}
