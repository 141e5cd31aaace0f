package robotran.robolang.nqc

import robotran.brick.controls.BrickButton
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.nqc.NqcResult
import robotran.nqc.compileNqc
import robotran.nqc.messages.NqcMessages
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.RcxProgram
import robotran.robolang.messages.NqcTranslationMessages
import robotran.robolang.translate.translatablePrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Robots drive the same way in Robolang and in the NQC that it becomes. */
class SameDrivingTest {
    @Test
    fun `the motors do the same for nearly the same time`() {
        val compared = PROGRAMS.map { name ->
            val program = translatablePrograms.getValue(name)
            val translation = translateToNqc(program, messages = NqcTranslationMessages.of(Language.ENGLISH))
            assertTrue(translation.isComplete, "$name ${translation.notes}")
            val compiled =
                compileNqc(translation.fileName, translation.nqc, messages = NqcMessages.of(Language.ENGLISH))
            assertTrue(compiled is NqcResult.Success, (compiled as? NqcResult.Failure)?.diagnostics.toString())
            val expected = phasesOf(program)
            val actual = phasesOf(compiled.program.forBrick(language = Language.ENGLISH))
            assertEquals(expected.map { it.first }, actual.map { it.first }, "$name\n${translation.nqc}")
            for ((one, other) in expected.zip(actual)) {
                val difference = one.second - other.second
                val allowed = maxOf(SHORT, one.second / PART)
                assertTrue(difference in -allowed..allowed, "$name ${one.first}: ${one.second} ms, ${other.second} ms")
            }
            expected.size
        }
        assertTrue(compared.sum() > 40, "$compared")
    }

    /** What the motors do, one after the other, each with its time in milliseconds. */
    private fun phasesOf(program: RcxProgram): List<Pair<String, Int>> {
        val brick = RcxBrick(listOf(program), InfraredAir(), messages = BrickMessages.of(Language.ENGLISH))
        brick.press(BrickButton.RUN)
        brick.release(BrickButton.RUN)
        val phases = mutableListOf<Pair<String, Int>>()
        for (millisecond in 0 until LONGEST) {
            brick.tick()
            if (millisecond > START && brick.state.run !is RunState.Running) break
            val motors = brick.kind.motorPorts.joinToString(" ") { brick.motor(it).mode.name }
            val last = phases.lastOrNull()
            if (last?.first == motors) {
                phases[phases.lastIndex] = motors to last.second + 1
            } else {
                phases += motors to 1
            }
        }
        // Between two motors' commands passes a little time, and before and after the program.
        return merged(phases.filter { (motors, time) -> time > SHORT && WARDS.any { it in motors } })
    }

    private fun merged(phases: List<Pair<String, Int>>): List<Pair<String, Int>> {
        val merged = mutableListOf<Pair<String, Int>>()
        for (phase in phases) {
            val last = merged.lastOrNull()
            if (last?.first == phase.first) {
                merged[merged.lastIndex] = phase.first to last.second + phase.second
            } else {
                merged += phase
            }
        }
        return merged
    }

    private companion object {
        val PROGRAMS = listOf("square.robo", "star.robo", "spiral.robo", "flower.robo", "letters.robo")
        val WARDS = listOf("FORWARD", "BACKWARD")
        const val LONGEST = 120_000
        const val START = 50

        /** Milliseconds that nobody sees. */
        const val SHORT = 25

        /** A duration may differ by this part of it. */
        const val PART = 50
    }
}
