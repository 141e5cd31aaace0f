package robotran.robolang.python

import robotran.language.Language
import robotran.language.fuzz.Fuzzing
import robotran.robolang.fuzz.ProgramWriter
import robotran.robolang.messages.PythonTranslationMessages
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

class PythonFuzzTest {
    @Test
    fun `MicroPython takes the translations of programs made at random`() {
        val messages = PythonTranslationMessages.of(Language.ENGLISH)
        val translations = (1..Fuzzing.share(1000, atLeast = 50)).associate { number ->
            val text = ProgramWriter(Random(Fuzzing.seed + number), isForNxt = true).write()
            val program = assertNotNull(programForHub(text, robot = nxtRobot), text)
            "$number" to translateToPython(program, program.robot, messages).python
        }
        if (!MicroPython.isHere) return
        val logs = MicroPython.run(translations.mapValues { (_, python) -> compiling(python) })
        val refused = logs.filterValues { it.last() != "# end 0" }.keys
        assertEquals(emptyList(), refused.map { "${logs[it]}\n${translations[it]}" }.take(3), "seed ${Fuzzing.seed}")
    }

    /** Python that compiles [python], and does not run it. */
    private fun compiling(python: String): String {
        val text = python.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n")
        return "compile(\"$text\", \"random.py\", \"exec\")\n"
    }
}
