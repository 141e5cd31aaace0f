package robotran.robolang.translate.thorough

import robotran.brick.controls.MotorPort
import robotran.language.Language
import robotran.robolang.Expectations
import robotran.robolang.RobolangNxtProgram
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.fuzz.ProgramWriter
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.robolang.testNxt
import robotran.robolang.testPrograms
import robotran.robolang.translate.LejosCompiler
import robotran.robolang.translate.interpretOnNxt
import robotran.robolang.translate.isReacting
import robotran.robolang.translate.nxtPrograms
import robotran.robolang.translate.runNxtJava
import robotran.robolang.translate.translateRobolang
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** A program that is translated for an NXT makes the interpreter's calls at the same times, if it has one thread. */
class NxtTranslatedRunTest {
    @Test
    fun `every translation makes the calls of the interpreter`() {
        val texts = testPrograms + documentedPrograms + examplePrograms
        val compared = compare(nxtPrograms) { Expectations(texts.getValue(it)) }
        assertTrue(compared >= 200, "only $compared programs were compared")
    }

    @Test
    fun `translations of programs made at random make the calls of the interpreter`() {
        val programs = (0 until RANDOM_PROGRAMS).associate { number ->
            val text = ProgramWriter(Random(number), isForNxt = true).write()
            val result = compileRobolang("random", text, testNxt, messages = RobolangMessages.of(Language.ENGLISH))
            "program $number" to (result as RobolangResult.Success).program as RobolangNxtProgram
        }
        val nothing = Expectations("")
        val compared = compare(programs) { nothing }
        assertTrue(compared >= RANDOM_PROGRAMS / 5, "only $compared programs were compared")
    }

    @Test
    fun `translations for motors elsewhere and the other way round make the calls of the interpreter`() {
        for (pen in listOf(MotorPort.A, null)) {
            val robot = testNxt.copy(left = MotorPort.C, right = MotorPort.B, pen = pen, isReversed = true)
            val programs = examplePrograms.mapNotNull { (path, text) ->
                val result = compileRobolang(
                    path,
                    text,
                    robot,
                    messages = RobolangMessages.of(Language.ENGLISH),
                ) as? RobolangResult.Success
                result?.let { path to it.program as RobolangNxtProgram }
            }.toMap()
            val nothing = Expectations("")
            val compared = compare(programs, robot) { nothing }
            assertTrue(compared >= 15, "only $compared programs were compared")
        }
    }

    /** Compares the programs without behaviours; returns how many were comparable and equal. */
    private fun compare(
        programs: Map<String, RobolangNxtProgram>,
        robot: RobotTarget = testNxt,
        senses: (path: String) -> Expectations,
    ): Int {
        val chosen = programs.filterValues { !isReacting(it) }
        val translations = chosen.entries.mapIndexed { index, (path, program) ->
            val named = RobolangProgram.of("P$index", program.checked, robot, RobolangMessages.of(Language.ENGLISH))
            path to translateRobolang(named)
        }.toMap()
        val classes = LejosCompiler.compileForNxt(translations.values)
        var equal = 0
        val different = chosen.mapNotNull { (path, program) ->
            val expected = senses(path)
            val interpreted = interpretOnNxt(program, expected) ?: return@mapNotNull null
            val translation = translations.getValue(path)
            val translated = runNxtJava(classes, translation.className, expected)
            val same = interpreted.zip(translated).takeWhile { (one, other) -> one == other }.size
            if (same == interpreted.size && same == translated.size) equal++
            val shown = "interpreted ${interpreted.drop(same).take(4)}, translated ${translated.drop(same).take(4)}"
            "$path: after $same calls $shown".takeIf { same < interpreted.size || same < translated.size }
        }
        assertEquals("", different.take(10).joinToString("\n"))
        return equal
    }

    private companion object {
        const val RANDOM_PROGRAMS = 150
    }
}
