package robotran.robolang.translate

import robotran.robolang.EnglishRunMessages
import robotran.robolang.Expectations
import robotran.robolang.RecordingRom
import robotran.robolang.RobolangProgram
import robotran.robolang.SensorEvent
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.testPrograms
import robotran.rom.ProgramStatus
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/**
 * Each program of the tests, the documents and the examples is translated, compiled against stand-ins for leJOS and run: it must make
 * the ROM calls of the interpreter, at the same times, and with behaviours in the same order.
 */
class TranslatedRunTest {
    private val texts = testPrograms + documentedPrograms + examplePrograms
    private val programs = translatablePrograms
    private val translations: Map<String, Translation> =
        programs.entries.mapIndexed { index, (path, program) -> path to translatedAs("P$index", program) }.toMap()

    @Test
    fun `every translation makes the calls of the interpreter`() {
        val compared = compare { !isReacting(it) }
        assertTrue(compared >= 150, "only $compared programs were compared")
    }

    @Test
    fun `every translation with behaviours makes the calls of the interpreter, one after the other`() {
        val compared = compare { isReacting(it) }
        assertTrue(compared >= 10, "only $compared programs were compared")
    }

    /** Compares the programs that are [wanted]; the answer is how many these were. */
    private fun compare(wanted: (RobolangProgram) -> Boolean): Int {
        val classes = LejosCompiler.compile(translations.values)
        val comparisons = programs.filterValues(wanted).keys.map { path -> compare(path, classes) }
        assertEquals("", comparisons.mapNotNull { it.difference }.joinToString("\n\n"))
        return comparisons.count { it.isDone }
    }

    private fun compare(path: String, classes: Map<String, ByteArray>): Comparison {
        val program = programs.getValue(path)
        val sensors = Expectations(texts.getValue(path)).sensors
        val translation = translations.getValue(path)
        val interpreted = interpret(program, sensors)
        if (!interpreted.isComparable || path in UNCERTAIN) return Comparison(isDone = false, null)
        val translated = try {
            runJava(classes, translation.className, RunTerms(sensors, MOST_CALLS, lastMillisecond(program)))
        } catch (failure: Throwable) {
            return Comparison(isDone = true, "$path: the translation fails with $failure\n${translation.java}")
        }
        val first = interpreted.calls.zip(translated).takeWhile { (left, right) -> agree(left, right, program) }.size
        if (first == interpreted.calls.size && first == translated.size) return Comparison(isDone = true, null)
        val calls = "interpreted ${interpreted.calls.drop(first).take(5)}, translated ${translated.drop(first).take(5)}"
        return Comparison(isDone = true, "$path: after $first calls $calls\n${translation.java}")
    }

    /** It takes two looks of the arbitrator until a behaviour has handed back to the main program. */
    private fun agree(interpreted: TimedCall, translated: TimedCall, program: RobolangProgram): Boolean {
        val late = translated.milliseconds - interpreted.milliseconds
        val latest = if (isReacting(program)) HANDING_BACK_MILLISECONDS * MOST_TAKEOVERS else 0
        return late in 0..latest && interpreted.copy(milliseconds = translated.milliseconds) == translated
    }

    private fun interpret(program: RobolangProgram, sensors: List<SensorEvent>): Interpreted {
        val rom = RecordingRom(sensors)
        val run = program.start(rom)
        var steps = 0
        while (rom.calls.size < MOST_CALLS && rom.milliseconds <= lastMillisecond(program) && steps++ < MOST_STEPS) {
            when (val status = run.resume(1)) {
                ProgramStatus.Running, is ProgramStatus.Paused -> Unit
                is ProgramStatus.Waiting -> rom.milliseconds = status.untilMilliseconds
                ProgramStatus.Ended -> break
                is ProgramStatus.Failed -> return Interpreted(emptyList(), isComparable = false)
            }
        }
        val calls = rom.calls.filter { it.milliseconds <= lastMillisecond(program) }.take(MOST_CALLS)
        return Interpreted(
            calls.map { TimedCall(it.milliseconds, it.call.address, it.call.arguments) },
            isComparable = steps < MOST_STEPS,
        )
    }

    private fun isReacting(program: RobolangProgram) = program.checked.tree.behaviours.isNotEmpty()

    private fun lastMillisecond(program: RobolangProgram): Long =
        if (isReacting(program)) LAST_MILLISECOND_OF_BEHAVIOURS else LAST_MILLISECOND

    private class Interpreted(val calls: List<TimedCall>, val isComparable: Boolean)

    private class Comparison(val isDone: Boolean, val difference: String?)

    private companion object {
        const val MOST_CALLS = 2_000
        const val MOST_STEPS = 300_000
        const val LAST_MILLISECOND = 100_000_000L
        const val LAST_MILLISECOND_OF_BEHAVIOURS = 20_000L
        const val HANDING_BACK_MILLISECONDS = 2
        const val MOST_TAKEOVERS = 5

        /** Its condition holds for no time at all: whether a brick notices is a matter of luck. */
        val UNCERTAIN = setOf("behaviours/interrupts-between-statements.robo")
    }
}

/** [program] in Java as the class [className]. */
internal fun translatedAs(className: String, program: RobolangProgram): Translation =
    translateRobolang(RobolangProgram(className, program.checked, program.calibration, EnglishRunMessages))
