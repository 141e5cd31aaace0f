package robotran.robolang.translate

import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.robolang.RecordingRom
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangRcxProgram
import robotran.robolang.SensorEvent
import robotran.robolang.messages.RobolangMessages

/**
 * Runs programs in the interpreter and translated to Java. Both must make the same ROM calls at the same times; with
 * behaviours, in the same order and almost at the same times.
 *
 * @property programs the programs by name.
 */
internal class RunComparison(private val programs: Map<String, RobolangRcxProgram>) {
    private val translations: Map<String, Translation> =
        programs.entries.mapIndexed { index, (name, program) -> name to translatedAs("P$index", program) }.toMap()

    /** The class files of all translations and of the leJOS stubs. */
    val classes: Map<String, ByteArray> = LejosCompiler.compile(translations.values)

    /** Compares both runs of the program [name] with the sensor values [sensors]. */
    fun compare(name: String, sensors: List<SensorEvent>): Comparison {
        val program = programs.getValue(name)
        val translation = translations.getValue(name)
        val interpreted = interpret(program, sensors) ?: return Comparison.Impossible
        val translated = try {
            runJava(classes, translation.className, RunTerms(sensors, MAX_CALLS, lastMillisecond(program)))
        } catch (failure: Throwable) {
            return Comparison.Different("$name: the translation fails with $failure\n${translation.java}")
        }
        // The last calls of an endless program may come after the time limit.
        val demanded = interpreted.count { it.milliseconds + latest(program) <= lastMillisecond(program) }
        val first = interpreted.zip(translated).takeWhile { (left, right) -> agree(left, right, program) }.size
        if (first >= demanded && first == translated.size) return Comparison.Same
        val calls = "interpreted ${interpreted.drop(first).take(5)}, translated ${translated.drop(first).take(5)}"
        return Comparison.Different("$name: after $first calls $calls\n${translation.java}")
    }

    /** The arbitrator checks twice before a behaviour has returned control to the main program. */
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

    /** The interpreter's calls; null if it fails, which a brick may not, or loops forever without a call. */
    private fun interpret(program: RobolangRcxProgram, sensors: List<SensorEvent>): List<TimedCall>? {
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

/** The result of comparing a translated run with an interpreted one. */
internal sealed interface Comparison {
    data object Same : Comparison

    data class Different(val words: String) : Comparison

    /** The interpreter fails or loops forever without a call, so there is nothing to compare. */
    data object Impossible : Comparison
}

internal fun isReacting(program: RobolangProgram): Boolean = program.checked.tree.behaviours.isNotEmpty()

/** Translates [program] to the Java class [className]. */
internal fun translatedAs(className: String, program: RobolangProgram): Translation = translateRobolang(
    RobolangProgram.of(className, program.checked, program.robot, RobolangMessages.of(Language.ENGLISH)),
)
