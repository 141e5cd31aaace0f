package robotran.programs

import robotran.language.Language
import robotran.rcxrom.program.RcxProgram
import robotran.robolang.RobolangRcxProgram
import robotran.tinyvm.config.TinyVmMode
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** A Robolang program and its leJOS translation, compiled and run on the virtual machine, behave the same. */
internal class TranslationDifferences {
    private val brickCompiler = ProgramCompiler(testTarget, language = Language.ENGLISH)
    private val forgivingCompiler =
        ProgramCompiler(testTarget, JavaSettings(TinyVmMode.FORGIVING), language = Language.ENGLISH)

    /** Compares each [share]-th program, at least [min] of them. */
    suspend fun compareCalls(share: Int, min: Int) {
        compareAll(robolangs.filterNot { it.hasBehaviours }.every(share), min) { program, java ->
            val interpreted = FixedClockRom(program.sensors)
            val translated = FixedClockRom(program.sensors)
            if (run(program.robolang, interpreted, MAX_CALLS, LAST_MILLISECOND) != Outcome.Done) return@compareAll null
            val outcome = run(java, translated, MAX_CALLS, LAST_MILLISECOND)
            if (outcome != Outcome.Done) {
                "ends with $outcome"
            } else {
                differenceOf(callsOf(interpreted), callsOf(translated))
            }
        }
    }

    /**
     * Compares each [share]-th program with behaviours, at least [min] of them. Behaviours need a brick whose clock runs
     * while it computes. Its threads take turns, so a call may come a little later.
     */
    suspend fun compareBehaviours(share: Int, min: Int) {
        val certain = robolangs.filter { it.hasBehaviours && it.path !in UNCERTAIN }
        compareAll(certain.every(share), min) { program, java ->
            val interpreted = runOnBrick(program.robolang, program.sensors, BEHAVIOUR_MILLISECONDS)
            val translated = runOnBrick(java, program.sensors, BEHAVIOUR_MILLISECONDS)
            // Of two endless programs, one has made more calls after the same time than the other.
            val max = if (interpreted.isOver || translated.isOver) {
                Int.MAX_VALUE
            } else {
                minOf(interpreted.calls.size, translated.calls.size)
            }
            differenceOf(ordered(interpreted.calls).take(max), ordered(translated.calls).take(max))
        }
    }

    /**
     * @param difference returns how a translation differs; an empty string for no difference, null if there is nothing
     * to compare with.
     */
    private suspend fun compareAll(programs: List<Robolang>, min: Int, difference: (Robolang, RcxProgram) -> String?) {
        val differences = mutableListOf<String>()
        var compared = 0
        for (program in programs) {
            val compiler = if (program.path in LARGE_DIVISORS) forgivingCompiler else brickCompiler
            val words = when (val result = compiler.translated(program.robolang)) {
                is ProgramResult.Success -> difference(program, result.program as RcxProgram) ?: continue
                is ProgramResult.Failure -> result.diagnostics.joinToString()
            }
            compared++
            if (words.isNotEmpty()) differences += "${program.path}: $words"
        }
        assertEquals("", differences.joinToString("\n"))
        assertTrue(compared >= min, "only $compared programs were compared")
    }

    private fun callsOf(rom: FixedClockRom) = rom.calls.filter {
        it.milliseconds <= LAST_MILLISECOND
    }.take(MAX_CALLS)

    private fun ordered(calls: List<TimedCall>) = calls.map { TimedCall(0, it.call.withoutAddresses()) }

    private fun differenceOf(interpreted: List<TimedCall>, translated: List<TimedCall>): String {
        val same = interpreted.zip(translated).takeWhile { (one, other) -> one == other }.size
        if (same == interpreted.size && same == translated.size) return ""
        return "after $same calls ${interpreted.drop(same).take(3)}, translated ${translated.drop(same).take(3)}"
    }

    private class Robolang(val path: String, text: String, val robolang: RobolangRcxProgram) {
        val sensors = sensorsIn(text)
        val hasBehaviours = text.lines().any { it.trim().startsWith("whenever") }
    }

    private companion object {
        const val MAX_CALLS = 2_000
        const val LAST_MILLISECOND = 20_000_000L
        const val BEHAVIOUR_MILLISECONDS = 20_000L

        /** A brick divides by the lowest 16 bits of a number, and Robolang warns about larger divisors. */
        val LARGE_DIVISORS = setOf("warnings/divisor-too-large.robo", "warnings/divisor-of-no-lower-bits.robo")

        /**
         * Two programs have conditions that hold for no time at all: a brick notices them only by chance. In the others
         * two conditions begin to hold at once: a brick checks one at a time and may see either first.
         */
        val UNCERTAIN = setOf(
            "behaviours/interrupts-between-statements.robo",
            "behaviours/an-action-that-ends-its-own-condition.robo",
            "behaviours/one-after-the-other.robo",
            "behaviours/later-one-comes-first.robo",
        )

        val robolangs: List<Robolang> = (robolangPrograms + robolangExamples).mapNotNull { (path, text) ->
            robolangOf(path, text)?.let { Robolang(path, text, it) }
        }
    }
}
