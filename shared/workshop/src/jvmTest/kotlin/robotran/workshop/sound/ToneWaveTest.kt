package robotran.workshop.sound

import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.checkAll
import kotlinx.coroutines.runBlocking
import robotran.runsound.Timbre
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sin
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class ToneWaveTest {
    private val wave = ToneWave()

    private fun ToneWave.take(milliseconds: Int, part: Int = 221): List<Int> = takeBoth(milliseconds, part).map {
        it.first
    }

    /** The samples for the left and for the right ear. */
    private fun ToneWave.takeBoth(milliseconds: Int, part: Int = 221): List<Pair<Int, Int>> {
        val wanted = milliseconds * ToneWave.SAMPLE_RATE / 1000
        val samples = mutableListOf<Pair<Int, Int>>()
        while (samples.size < wanted) {
            val both = ShortArray(ToneWave.CHANNELS * part).also { fill(it) }
            samples += both.toList().chunked(ToneWave.CHANNELS) { (left, right) -> left.toInt() to right.toInt() }
        }
        return samples.take(wanted)
    }

    private fun at(milliseconds: Double) = (milliseconds * ToneWave.SAMPLE_RATE / 1000).toInt()

    /** The strength of the frequency [hertz] in these samples. */
    private fun List<Int>.strengthOf(hertz: Double): Double {
        val turn = 2 * PI * hertz / ToneWave.SAMPLE_RATE
        return 2 * hypot(indices.sumOf { this[it] * cos(turn * it) }, indices.sumOf { this[it] * sin(turn * it) }) /
            size
    }

    @Test
    fun `a tone begins and ends at its moments and there is silence around it`() {
        wave.play(PlannedTone(start = 20.0, hertz = 1000.0, duration = 30.0))
        val samples = wave.take(100)
        assertTrue(samples.take(at(20.0)).all { it == 0 })
        assertTrue(samples.subList(at(23.0), at(49.0)).map(::abs).average() > 4_000)
        assertTrue(samples.drop(at(50.0 + ToneWave.RAMP_MILLISECONDS) + 2).all { it == 0 })
        assertTrue(wave.isSilent)
    }

    @Test
    fun `every frequency of the brick is the strongest in its tone`() = runBlocking {
        checkAll(60, Arb.double(31.0, 20_000.0)) { hertz ->
            val tone = ToneWave()
            tone.play(PlannedTone(0.0, hertz, 1_000.0))
            val samples = tone.take(500).drop(at(5.0))
            val own = samples.strengthOf(hertz)
            assertTrue(own > 5_000, "$hertz Hz has only $own")
            for (other in listOf(hertz / 2, hertz * 1.37, 22_050 - hertz)) {
                if (abs(other - hertz) > 50 && other in 20.0..22_000.0) {
                    assertTrue(samples.strengthOf(other) < own / 8, "$other in $hertz Hz")
                }
            }
        }
    }

    @Test
    fun `a tone with half the volume is half as loud`() {
        val loudness = listOf(1.0, 0.5, 0.0).map { volume ->
            val tone = ToneWave()
            tone.play(PlannedTone(0.0, 440.0, 1_000.0, volume))
            tone.take(500).drop(at(5.0)).strengthOf(440.0)
        }
        assertEquals(loudness[0] / 2, loudness[1], absoluteTolerance = loudness[0] / 100)
        assertEquals(0.0, loudness[2])
    }

    @Test
    fun `a soft tone has no overtones, the other has`() {
        val (soft, hard) = listOf(Timbre.SINE, Timbre.SQUARE).map { timbre ->
            val tone = ToneWave()
            tone.play(PlannedTone(0.0, 440.0, 1_000.0, timbre = timbre))
            tone.take(500).drop(at(5.0))
        }
        assertTrue(soft.strengthOf(3 * 440.0) < soft.strengthOf(440.0) / 50)
        assertTrue(hard.strengthOf(3 * 440.0) > hard.strengthOf(440.0) / 4)
    }

    @Test
    fun `the wave is as loud below its middle as above and never too loud`() {
        for (hertz in listOf(31.0, 100.0, 440.0, 2000.0, 7_000.0, 8_000.0, 20_000.0)) {
            val tone = ToneWave()
            tone.play(PlannedTone(0.0, hertz, 1_000.0))
            val samples = tone.take(900).drop(at(5.0))
            assertTrue(samples.all { abs(it) < 12_000 }, "$hertz Hz is too loud")
            assertTrue(abs(samples.average()) < 300, "$hertz Hz lies beside its middle")
        }
    }

    @Test
    fun `where a tone follows another the wave goes on without a pause or a jump`() {
        wave.play(PlannedTone(0.0, 300.0, 50.0))
        wave.play(PlannedTone(50.0, 310.0, 50.0))
        val changes = wave.take(90).drop(at(5.0)).map { if (it > 0) 1 else -1 }.zipWithNext { one, next -> one != next }
        val halves = changes.withIndex().filter { it.value }.map { it.index }.zipWithNext { one, next -> next - one }
        assertTrue(halves.all { it in 70..74 }, "half waves last $halves samples")
    }

    @Test
    fun `a tone that is ended falls silent within the ramp`() {
        wave.play(PlannedTone(0.0, 500.0, 2_000.0))
        wave.take(100)
        wave.endAt(wave.milliseconds)
        val samples = wave.take(20)
        assertTrue(samples.drop(at(ToneWave.RAMP_MILLISECONDS) + 2).all { it == 0 })
        assertTrue(wave.isSilent)
    }

    @Test
    fun `silence forgets what was to come`() {
        wave.play(PlannedTone(50.0, 500.0, 100.0))
        wave.silence()
        assertTrue(wave.take(200).all { it == 0 })
    }

    @Test
    fun `a tone takes the place of those that would begin later or still sound`() {
        wave.play(PlannedTone(0.0, 500.0, 100.0))
        wave.play(PlannedTone(60.0, 600.0, 100.0))
        wave.play(PlannedTone(30.0, 2000.0, 20.0))
        val samples = wave.take(200)
        assertTrue(samples.subList(at(32.0), at(49.0)).strengthOf(2000.0) > 5_000)
        assertTrue(samples.drop(at(53.0)).all { it == 0 })
    }

    @Test
    fun `the samples do not depend on how many are taken at once`() {
        val tones = List(8) { PlannedTone(it * 37.3, 200.0 + 311 * it, 35.0) }
        val other = ToneWave()
        tones.forEach(wave::play)
        tones.forEach(other::play)
        assertEquals(wave.take(400, part = 64), other.take(400, part = 1_000))
        assertFalse(other.milliseconds < 400.0)
    }

    @Test
    fun `a tone in the middle is the same in both ears, one at the side in its own alone`() {
        for ((pan, ears) in listOf(0.0 to setOf(1, 2), -1.0 to setOf(1), 1.0 to setOf(2))) {
            val tone = ToneWave()
            tone.play(PlannedTone(0.0, 440.0, 200.0, pan = pan))
            val both = tone.takeBoth(100)
            val heard = setOfNotNull(1.takeIf { both.any { it.first != 0 } }, 2.takeIf { both.any { it.second != 0 } })
            assertEquals(ears, heard, "$pan")
            if (pan == 0.0) assertTrue(both.all { it.first == it.second })
        }
    }

    @Test
    fun `a tone that goes on in the other ear has no jump`() {
        wave.play(PlannedTone(0.0, 200.0, 50.0, timbre = Timbre.SINE, pan = -1.0))
        wave.play(PlannedTone(50.0, 200.0, 50.0, timbre = Timbre.SINE, pan = 1.0))
        val right = wave.takeBoth(90).map { it.second }
        assertTrue(right.zipWithNext { one, next -> abs(next - one) }.max() < 500)
        assertTrue(right.drop(at(53.0)).any { abs(it) > 4_000 })
    }

    @Test
    fun `a saw has all overtones`() {
        wave.play(PlannedTone(0.0, 440.0, 1_000.0, timbre = Timbre.SAWTOOTH))
        val samples = wave.take(500).drop(at(5.0))
        assertTrue(samples.strengthOf(2 * 440.0) > samples.strengthOf(440.0) / 4)
        assertTrue(samples.all { abs(it) < 12_000 } && abs(samples.average()) < 300)
    }

    @Test
    fun `the tones of a brick are the samples that they have always been`() {
        wave.play(PlannedTone(0.0, 440.0, 100.0))
        wave.play(PlannedTone(120.0, 2_000.0, 30.0, volume = 0.4))
        wave.play(PlannedTone(150.0, 523.25, 50.0))
        assertEquals(-653_077_398, wave.take(210).fold(7) { hash, sample -> 31 * hash + sample })
    }
}
