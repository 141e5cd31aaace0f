package robotran.runsound

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class SoundSampleTest {
    @Test
    fun `each sample begins at once, is short, and does not overlap with itself`() {
        for (sample in SoundSample.entries) {
            val tones = sample.tones
            assertEquals(0, tones.first().milliseconds, "$sample")
            assertTrue(tones.last().milliseconds < 3_000, "$sample")
            tones.zipWithNext { one, next ->
                assertTrue(next.milliseconds >= one.milliseconds + one.duration, "$sample")
            }
        }
    }

    @Test
    fun `the wall comes nearer in the sample as it does in a run`() {
        val pitches = SoundSample.WALL_AHEAD.tones.map { it.hertz }
        assertEquals(pitches.sorted(), pitches)
    }

    @Test
    fun `there is a pitch for each step of distance, and one more for nothing ahead`() {
        assertEquals(SoundValues.STEPS.size + 1, SoundValues.PITCHES.size)
        assertEquals(SoundValues.STEPS.sorted(), SoundValues.STEPS.toList())
        assertEquals(SoundValues.PITCHES.sortedDescending(), SoundValues.PITCHES.toList())
    }
}
