package robotran.robolang.nqc

import robotran.language.Language
import robotran.nqc.NqcResult
import robotran.nqc.compileNqc
import robotran.nqc.messages.NqcMessages
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.NqcTranslationMessages
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robotFor
import robotran.robolang.translate.nxtPrograms
import robotran.robolang.translate.translatablePrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class TranslateToNqcTest {
    @Test
    fun `every translation compiles`() {
        val failures = translatablePrograms.mapNotNull { (path, program) ->
            val translation = translateToNqc(program, messages = NqcTranslationMessages.of(Language.ENGLISH))
            val result = compileNqc(
                translation.fileName,
                translation.nqc,
                messages = NqcMessages.of(Language.ENGLISH),
            ) as? NqcResult.Failure
            val isTooLarge = result?.diagnostics?.all { it.code?.id in TOO_LARGE } ?: true
            if (isTooLarge) null else "$path: ${result?.diagnostics}\n${translation.nqc}"
        }
        assertTrue(failures.isEmpty(), failures.take(5).joinToString("\n\n"))
    }

    @Test
    fun `many programs go over completely`() {
        val complete = translatablePrograms.values.count {
            translateToNqc(it, messages = NqcTranslationMessages.of(Language.ENGLISH)).isComplete
        }
        assertTrue(complete > translatablePrograms.size / 4, "$complete of ${translatablePrograms.size}")
    }

    @Test
    fun `moves and loops`() {
        val lines = linesOf("repeat 4 times\n  forward 20\n  turn right 90\nend\nstop\nbeep")
        val expected = listOf(
            "task main() {",
            "SetPower(OUT_A + OUT_B + OUT_C, 3);",
            "repeat (4) {",
            "forward(CM(20));",
            "turnRight(DEGREES(90));",
            "}",
            "Off(LEFT + RIGHT);",
            "PlaySound(SOUND_CLICK);",
            "}",
        )
        assertEquals(expected, lines.dropWhile { !it.startsWith("task") }.filter { it.isNotEmpty() })
        assertTrue("#define LEFT OUT_A" in lines)
        assertTrue("void forward(const int &time) {" in lines)
    }

    @Test
    fun `functions give their value to a variable`() {
        val lines = linesOf("function double(x)\n  return x * 2\nend\nvar a = double(3) + 1\nshow a")
        assertTrue(lines.containsAll(listOf("void double(int &result, int x) {", "result = x * 2;")), lines.toString())
        val place = lines.indexOf("int result_;").takeIf { it >= 0 } ?: lines.indexOf("int result;")
        assertEquals(listOf("double(${lines[place].drop(4).dropLast(1)}, 3);"), lines.subList(place + 1, place + 2))
    }

    @Test
    fun `what does not go over is told`() {
        val lost = listOf(
            "show \"HELLO\"" to "texts",
            "var a = [1, 2]\na = [3]\nshow a[0]" to "Lists",
            "var a = 1.5\nshow a * 2" to "decimal",
            "show 100000" to "too large",
            "if button run\n  beep\nend" to "buttons",
            "whenever left bumper\n  stop\nend\nforward 10" to "whenever",
            "procedure p(n)\n  if n > 0\n    p(n - 1)\n  end\nend\np(3)" to "calls itself",
            "show sqrt(2)" to "decimal",
        )
        for ((source, sentence) in lost) {
            val translation = translationOf(source)
            assertFalse(translation.isComplete, source)
            assertTrue(translation.notes.any { sentence in it.message }, "$source ${translation.notes}")
        }
    }

    @Test
    fun `measured values are scaled`() {
        val lines =
            linesOf("wait until timer > 2.5\nwait until timer >= 0.25\nif battery < 7.2\n  buzz\nend\nwait 1.5 seconds")
        val expected =
            listOf(
                "until (Timer(0) > 25);",
                "until (FastTimer(0) >= 25);",
                "if (BatteryLevel() < 7200) {",
                "Wait(150);",
            )
        assertTrue(lines.containsAll(expected), lines.toString())
    }

    @Test
    fun `a program for an NXT does not go over`() {
        val translation =
            translateToNqc(nxtPrograms.values.first(), messages = NqcTranslationMessages.of(Language.ENGLISH))
        assertFalse(translation.isComplete)
        assertTrue(translation.nqc.startsWith("// NQC is for an RCX"))
    }

    @Test
    fun `remarks are in the language of the pupil`() {
        val messages = Language.entries.map {
            translationOf("show \"HI\"", NqcTranslationMessages.of(it)).notes.single()
        }
        assertEquals(Language.entries.size, messages.map { it.message }.distinct().size)
    }

    @Test
    fun `lines know where they come from`() {
        val translation = translationOf("// Drives.\nforward 20\n\nbeep")
        val line = translation.nqc.lines().indexOf("    PlaySound(SOUND_CLICK);") + 1
        assertEquals(4, translation.lineMap.sourceLineOf(line))
    }

    private fun linesOf(source: String) = translationOf(source).nqc.lines().map { it.trim() }

    private fun translationOf(
        source: String,
        messages: NqcTranslationMessages = NqcTranslationMessages.of(Language.ENGLISH),
    ): NqcTranslation = when (
        val result =
            compileRobolang("test.robo", source, robotFor(source), messages = RobolangMessages.of(Language.ENGLISH))
    ) {
        is RobolangResult.Success -> translateToNqc(result.program, messages)
        is RobolangResult.Failure -> throw AssertionError(result.diagnostics.joinToString("\n") { it.message })
    }

    private companion object {
        /** A brick has less room for variables and code than Robolang allows. */
        val TOO_LARGE = setOf("no-storage", "no-temporaries", "program-too-long", "nested-too-deeply")
    }
}
