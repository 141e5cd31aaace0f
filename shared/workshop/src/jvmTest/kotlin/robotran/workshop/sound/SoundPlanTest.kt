package robotran.workshop.sound

import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import kotlinx.coroutines.runBlocking
import robotran.brick.sound.SoundEvent
import robotran.runsound.RunSign
import robotran.runsound.RunTone
import robotran.runsound.Timbre
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class SoundPlanTest {
    private val speaker = RecordingSpeaker()
    private val plan = SoundPlan(speaker)
    private val melody =
        List(10) {
            SoundEvent.Tone(milliseconds = 1000L + it * 60, hertz = 500.0 + it * 100, durationMilliseconds = 60)
        }

    /** Passes each event to the plan at the speaker's time [timeOf] of its time, in steps of one frame. */
    private fun hear(events: List<SoundEvent>, timeOf: (Long) -> Double) {
        for (event in events) {
            val frames = kotlin.math.ceil(timeOf(event.milliseconds) / FRAME)
            speaker.milliseconds = frames * FRAME
            plan.add(listOf(event))
        }
    }

    @Test
    fun `in real time a melody keeps its rhythm although frames bring it unevenly`() {
        hear(melody) { it.toDouble() }
        assertEquals(melody.map { it.hertz }, speaker.tones.map { it.hertz })
        speaker.tones.zipWithNext { tone, next -> assertEquals(tone.end, next.start, absoluteTolerance = 1e-6) }
    }

    @Test
    fun `the first tone begins a moment after the news of it`() {
        speaker.milliseconds = 500.0
        plan.add(melody.take(1))
        assertEquals(PlannedTone(500.0 + SoundPlan.LEAD, 500.0, 60.0), speaker.tones.single())
    }

    @Test
    fun `a tone keeps the volume of its brick, and an NXT's are soft`() {
        SoundPlan(speaker, timbre = Timbre.SINE).add(listOf(SoundEvent.Tone(0, 440.0, 100, volume = 40)))
        assertEquals(
            PlannedTone(SoundPlan.LEAD, 440.0, 100.0, volume = 0.4, timbre = Timbre.SINE),
            speaker.tones.single(),
        )
    }

    @Test
    fun `beeps that come while the sound card is being opened keep their rhythm`() {
        plan.add(listOf(SoundEvent.Tone(20, 1000.0, 150)))
        plan.add(listOf(SoundEvent.Tone(220, 1000.0, 150)))
        assertEquals(listOf(60.0, 260.0), speaker.tones.map { it.start })
    }

    @Test
    fun `after a long rest a tone begins as soon as the first, although the clock stood still`() {
        plan.add(melody.take(1))
        speaker.milliseconds = 200.0
        plan.add(listOf(SoundEvent.Tone(90_000, 440.0, 100)))
        assertEquals(200.0 + SoundPlan.LEAD, speaker.tones.last().start)
    }

    @Test
    fun `in slow motion every tone sounds at its pitch, later`() {
        hear(melody) { it * 4.0 }
        assertEquals(melody.size, speaker.tones.size)
        assertTrue(speaker.tones.all { it.duration == 60.0 })
        speaker.tones.zipWithNext { tone, next -> assertTrue(next.start - tone.start > 200) }
    }

    @Test
    fun `in fast motion tones are left out and none is cut short or waits for long`() {
        val beeps = List(200) { SoundEvent.Tone(it * 60L, 1000.0, 60) }
        val asked = mutableListOf<Double>()
        for (event in beeps) {
            speaker.milliseconds = event.milliseconds / 10.0
            val before = speaker.tones.size
            plan.add(listOf(event))
            if (speaker.tones.size > before) asked += speaker.milliseconds
        }
        assertTrue(speaker.tones.size in 5..30, "${speaker.tones.size} tones in ${speaker.milliseconds} ms")
        speaker.tones.zipWithNext { tone, next -> assertTrue(next.start >= tone.end - 1e-6, "$tone before $next") }
        speaker.tones.zip(asked) { tone, now -> assertTrue(tone.start - now <= SoundPlan.MAX_AHEAD) }
    }

    @Test
    fun `a cut ends a tone after as long as it sounded on the brick`() {
        plan.add(listOf(SoundEvent.Tone(1000, 440.0, 500), SoundEvent.Cut(1200)))
        assertEquals(speaker.tones.single().start + 200, speaker.ends.single())
    }

    @Test
    fun `a cut that comes late ends the tone at once`() {
        plan.add(listOf(SoundEvent.Tone(1000, 440.0, 2_000)))
        speaker.milliseconds = 1_900.0
        plan.add(listOf(SoundEvent.Cut(1200)))
        assertEquals(1_900.0, speaker.ends.single())
    }

    @Test
    fun `a cut of a tone that is over changes nothing`() {
        plan.add(listOf(SoundEvent.Tone(1000, 440.0, 100)))
        speaker.milliseconds = 300.0
        plan.add(listOf(SoundEvent.Cut(1300)))
        assertEquals(emptyList(), speaker.ends)
    }

    @Test
    fun `tones that each cut the one before are all heard`() {
        val siren = List(20) { listOf(SoundEvent.Cut(it * 30L), SoundEvent.Tone(it * 30L, 500.0 + it, 1000)) }.flatten()
        hear(siren) { it.toDouble() }
        assertEquals(20, speaker.tones.size)
        assertEquals(19, speaker.ends.size)
    }

    @Test
    fun `whatever comes whenever, nothing is planned further ahead than a moment`() = runBlocking {
        checkAll(Arb.list(Arb.int(0..300), 0..60), Arb.double(0.05, 50.0)) { gaps, speed ->
            val clock = RecordingSpeaker()
            val planner = SoundPlan(clock)
            var brick = 0L
            for (gap in gaps) {
                brick += gap
                clock.milliseconds = brick / speed
                planner.add(
                    listOf(
                        if (gap % 3 == 0) {
                            SoundEvent.Cut(brick)
                        } else {
                            SoundEvent.Tone(brick, 440.0, 10 + gap)
                        },
                    ),
                )
                clock.tones.lastOrNull()?.let { assertTrue(it.start <= clock.milliseconds + SoundPlan.MAX_AHEAD) }
            }
        }
    }

    private fun tick(milliseconds: Long, duration: Int = 10) =
        RunTone(milliseconds, RunSign.WHEEL, 800.0, duration, -0.5, Timbre.SAWTOOTH, 0.5)

    @Test
    fun `a tone of the run keeps its place between the ears, its timbre and its loudness`() {
        plan.add(emptyList(), listOf(tick(20)))
        assertEquals(PlannedTone(60.0, 800.0, 10.0, 0.5, Timbre.SAWTOOTH, -0.5), speaker.tones.single())
    }

    @Test
    fun `tones of the run and of the brick are played in the order of their times`() {
        plan.add(listOf(SoundEvent.Tone(40, 440.0, 100)), listOf(tick(0), tick(20), tick(160)))
        assertEquals(listOf(800.0, 800.0, 440.0, 800.0), speaker.tones.map { it.hertz })
        assertEquals(speaker.tones.map { it.start }.sorted(), speaker.tones.map { it.start })
    }

    @Test
    fun `no tone of the run begins while the brick sounds, at any speed`() = runBlocking {
        val times = Arb.list(Arb.int(0..5_000), 1..80)
        checkAll(200, times, times, Arb.double(0.1, 10.0)) { beeps, ticks, speed ->
            val loud = RecordingSpeaker()
            val own = SoundPlan(loud)
            for (from in 0..5_000 step 20) {
                loud.milliseconds = from / speed
                val events = beeps.filter {
                    it in from..<from + 20
                }.sorted().map { SoundEvent.Tone(it.toLong(), 440.0, 90) }
                own.add(events, ticks.filter { it in from..<from + 20 }.sorted().map { tick(it.toLong()) })
            }
            var until = 0.0
            for (tone in loud.tones) {
                if (tone.hertz == 440.0) until = tone.end else assertTrue(tone.start >= until, "$tone at $speed")
            }
        }
    }

    private companion object {
        /** Milliseconds. */
        const val FRAME = 1000.0 / 60
    }
}
