package robotran.hub

import robotran.brick.sound.SoundEvent
import robotran.hub.program.HubNative
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class SpeakerTest {
    private val bench = HubBench()
    private val begin = bench.milliseconds

    @Test
    fun `beeps are those of Pybricks, one after the other`() {
        val known = recorded("26-speaker-events").take(6).filter { "beep" in it && "beep 0" !in it }
            .map { line -> line.split(' ').let { it[0].toLong() - 2 to it[2].toDouble() } }
        for ((hertz, milliseconds) in listOf(500 to 100, 440 to 300, 262 to -1)) {
            bench.call(HubNative.SPEAKER_BEEP, hertz, milliseconds)
            bench.until { bench.hub.beepMillisecondsLeft == 0 }
        }
        val tones = bench.brick.sounds.since(0).filterIsInstance<SoundEvent.Tone>()
        assertEquals(known, tones.map { it.milliseconds - begin to it.hertz })
    }

    @Test
    fun `a beep without end sounds until the next, and nobody waits for it`() {
        bench.call(HubNative.SPEAKER_BEEP, 262, -1)
        assertEquals(0, bench.hub.beepMillisecondsLeft)
        bench.wait(50)
        assertTrue(bench.brick.isSounding)
        bench.call(HubNative.SPEAKER_BEEP, 0, 10)
        assertFalse(bench.brick.isSounding)
        assertEquals(SoundEvent.Cut(begin + 50), bench.brick.sounds.since(0).last())
    }
}
