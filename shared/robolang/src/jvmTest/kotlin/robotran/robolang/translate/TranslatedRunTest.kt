package robotran.robolang.translate

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
        val own = RobolangProgram("P$index", program.checked, program.calibration)
        path to translateRobolang(own)
    }.toMap()

    @Test
    fun `every translation makes the calls of the interpreter`() {
        assertTrue(programs.size >= 50, "only ${programs.size} programs were found")
        val classes = LejosCompiler.compile(translations.values)
        val differences = programs.keys.filter { it !in UNLIKE }.mapNotNull { path -> difference(path, classes) }
        assertEquals("", differences.joinToString("\n\n"))
    }

    private fun difference(path: String, classes: Map<String, ByteArray>): String? {
        val translation = translations.getValue(path)
        val interpreted = interpret(programs.getValue(path))
        val translated = runJava(classes, translation.className, MOST_CALLS, LAST_MILLISECOND)
        if (interpreted == translated) return null
        val first = interpreted.zip(translated).indexOfFirst { (left, right) -> left != right }
        return "$path: interpreted ${interpreted.drop(first).take(5)}, translated ${translated.drop(first).take(5)}\n${translation.java}"
    }

    private fun interpret(program: RobolangProgram): List<TimedCall> {
        val rom = RecordingRom()
        val run = program.start(rom)
        while (rom.calls.size < MOST_CALLS && rom.milliseconds <= LAST_MILLISECOND) {
            when (val status = run.resume(1)) {
                ProgramStatus.Running -> Unit
                is ProgramStatus.Waiting -> rom.milliseconds = status.untilMilliseconds
                ProgramStatus.Ended, is ProgramStatus.Failed -> break
            }
        }
        return rom.calls.map { TimedCall(it.milliseconds, it.call.address, it.call.arguments) }.take(MOST_CALLS)
    }

    private companion object {
        const val MOST_CALLS = 2_000
        const val LAST_MILLISECOND = 200_000_000L

        val UNLIKE = emptySet<String>()
    }
}
