package robotran.robolang.translate

import robotran.rcxrom.program.ProgramStatus
import robotran.robolang.RecordingRom
import robotran.robolang.RobolangProgram
import robotran.robolang.SensorEvent
import robotran.robolang.messages.EnglishRobolangMessages

/**
 * Translates, compiles and runs programs beside the interpreter: both must make the same ROM calls at the same times,
 * and with behaviours in the same order.
 *
 * @property programs the programs by name.
 */
internal class RunComparison(private val programs: Map<String, RobolangProgram>) {
    private val translations: Map<String, Translation> =
        programs.entries.mapIndexed { index, (name, program) -> name to translatedAs("P$index", program) }.toMap()

    /** The class files of all translations and of the stand-ins for leJOS. */
    val classes: Map<String, ByteArray> = LejosCompiler.compile(translations.values)

    /** How the program called [name] fares while its sensors measure [sensors]. */
    fun compare(name: String, sensors: List<SensorEvent>): Comparison {
        val program = programs.getValue(name)
        val translation = translations.getValue(name)
        val interpreted = interpret(program, sensors) ?: return Comparison.Impossible
        val translated = try {
            runJava(classes, translation.className, RunTerms(sensors, MAX_CALLS, lastMillisecond(program)))
        } catch (failure: Throwable) {
            return Comparison.Different("$name: the translation fails with $failure\n${translation.java}")
        }
        // The last calls of one that never ends may come when the time is up.
        val demanded = interpreted.count { it.milliseconds + latest(program) <= lastMillisecond(program) }
        val first = interpreted.zip(translated).takeWhile { (left, right) -> agree(left, right, program) }.size
        if (first >= demanded && first == translated.size) return Comparison.Same
        val calls = "interpreted ${interpreted.drop(first).take(5)}, translated ${translated.drop(first).take(5)}"
        return Comparison.Different("$name: after $first calls $calls\n${translation.java}")
    }

    /** It takes two looks of the arbitrator until a behaviour has handed back to the main program. */
    private fun agree(interpreted: TimedCall, translated: TimedCall, program: RobolangProgram): Boolean {
        val late = translated.milliseconds - interpreted.milliseconds
        return late in 0..latest(program) && interpreted.copy(milliseconds = translated.milliseconds) == translated
    }

    private fun latest(program: RobolangProgram): Long = if (isReacting(program)) {
        HANDING_BACK_MILLISECONDS *
            MAX_TAKEOVERS
    } else {
        0
    }

    /** The calls of the interpreter, null if it fails, which a brick may not, or goes on for ever without a call. */
    private fun interpret(program: RobolangProgram, sensors: List<SensorEvent>): List<TimedCall>? {
        val rom = RecordingRom(sensors)
        val run = program.start(rom)
        var steps = 0
        while (rom.calls.size < MAX_CALLS && rom.milliseconds <= lastMillisecond(program)) {
            if (steps++ == MAX_STEPS) return null
            when (val status = run.resume(1)) {
                ProgramStatus.Running, is ProgramStatus.Paused, is ProgramStatus.ThreadFailed -> Unit
                is ProgramStatus.Waiting -> rom.milliseconds = status.untilMilliseconds
                ProgramStatus.Ended -> break
                is ProgramStatus.ThreadFailed, is ProgramStatus.Failed -> return null
            }
        }
        return rom.calls.filter { it.milliseconds <= lastMillisecond(program) }.take(MAX_CALLS)
            .map { TimedCall(it.milliseconds, it.call.address, it.call.arguments) }
    }

    private fun lastMillisecond(program: RobolangProgram): Long =
        if (isReacting(program)) LAST_MILLISECOND_OF_BEHAVIOURS else LAST_MILLISECOND

    private companion object {
        const val MAX_CALLS = 2_000
        const val MAX_STEPS = 300_000
        const val LAST_MILLISECOND = 100_000_000L
        const val LAST_MILLISECOND_OF_BEHAVIOURS = 20_000L
        const val HANDING_BACK_MILLISECONDS = 2L
        const val MAX_TAKEOVERS = 5
    }
}

/** What came of comparing a run of a translation with one of the interpreter. */
internal sealed interface Comparison {
    data object Same : Comparison

    data class Different(val words: String) : Comparison

    /** The interpreter's run has nothing to be compared with. */
    data object Impossible : Comparison
}

internal fun isReacting(program: RobolangProgram): Boolean = program.checked.tree.behaviours.isNotEmpty()

/** [program] in Java as the class [className]. */
internal fun translatedAs(className: String, program: RobolangProgram): Translation =
    translateRobolang(RobolangProgram(className, program.checked, program.calibration, EnglishRobolangMessages))
