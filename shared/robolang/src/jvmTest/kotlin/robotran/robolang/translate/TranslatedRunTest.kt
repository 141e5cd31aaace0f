package robotran.robolang.translate

import robotran.robolang.EnglishRunMessages
import robotran.robolang.RecordingRom
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.readRobolang
import robotran.robolang.testCalibration
import robotran.robolang.testPrograms
import robotran.rom.ProgramStatus
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/**
 * Each program of the tests, the document and the examples is translated, compiled against stand-ins for leJOS and run: it must make
 * the same ROM calls at the same times as the interpreter.
 */
class TranslatedRunTest {
    private val programs: Map<String, RobolangProgram> = (testPrograms + documentedPrograms + examplePrograms).entries
        .mapNotNull { (path, text) -> (readRobolang(path, text, testCalibration) as? RobolangResult.Ready)?.let { path to it.program } }
        .toMap()

    private val translations: Map<String, Translation> = programs.entries.mapIndexed { index, (path, program) ->
        val own = RobolangProgram("P$index", program.checked, program.calibration, EnglishRunMessages)
        path to translateRobolang(own)
    }.toMap()

    @Test
    fun `every translation makes the calls of the interpreter`() {
        assertTrue(programs.size >= 50, "only ${programs.size} programs were found")
        val classes = LejosCompiler.compile(translations.values)
        val differences = programs.keys.mapNotNull { path -> difference(path, classes) }
        assertEquals("", differences.joinToString("\n\n"))
    }

    private fun difference(path: String, classes: Map<String, ByteArray>): String? {
        val translation = translations.getValue(path)
        val interpreted = interpret(programs.getValue(path))
        // Only compiled: what the interpreter refuses to do, what never ends without a call, and behaviours, whose threads a brick
        // switches when it likes.
        if (!interpreted.isComparable || programs.getValue(path).checked.tree.behaviours.isNotEmpty()) return null
        val translated = try {
            runJava(classes, translation.className, MOST_CALLS, LAST_MILLISECOND)
        } catch (failure: Throwable) {
            return "$path: the translation fails with $failure\n${translation.java}"
        }
        if (interpreted.calls == translated) return null
        val first = interpreted.calls.zip(translated).takeWhile { (left, right) -> left == right }.size
        val calls = "interpreted ${interpreted.calls.drop(first).take(5)}, translated ${translated.drop(first).take(5)}"
        return "$path: after $first calls $calls\n${translation.java}"
    }

    private fun interpret(program: RobolangProgram): Interpreted {
        val rom = RecordingRom()
        val run = program.start(rom)
        var hasFailed = false
        var steps = 0
        while (rom.calls.size < MOST_CALLS && rom.milliseconds <= LAST_MILLISECOND && steps++ < MOST_STEPS) {
            when (val status = run.resume(1)) {
                ProgramStatus.Running, is ProgramStatus.Paused -> {
                    Unit
                }

                is ProgramStatus.Waiting -> {
                    if (status.untilMilliseconds >
                        LAST_MILLISECOND
                    ) {
                        break
                    } else {
                        rom.milliseconds = status.untilMilliseconds
                    }
                }

                ProgramStatus.Ended -> {
                    break
                }

                is ProgramStatus.Failed -> {
                    hasFailed = true
                    break
                }
            }
        }
        val calls = rom.calls.map { TimedCall(it.milliseconds, it.call.address, it.call.arguments) }.take(MOST_CALLS)
        return Interpreted(calls, isComparable = !hasFailed && steps < MOST_STEPS)
    }

    private class Interpreted(val calls: List<TimedCall>, val isComparable: Boolean)

    private companion object {
        const val MOST_CALLS = 2_000
        const val MOST_STEPS = 300_000
        const val LAST_MILLISECOND = 100_000_000L
    }
}
