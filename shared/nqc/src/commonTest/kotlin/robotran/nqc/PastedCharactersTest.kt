package robotran.nqc

import robotran.language.Language
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.messages.NqcMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** What word processors, mails and web pages make of a program. */
class PastedCharactersTest {
    @Test
    fun `pasted characters are told by their names and become those of a keyboard`() {
        assertMended("Wait(50 \u2212 20);", "Wait(50 - 20);", "a dash of a word processor")
        assertMended("Wait(50);\u2013\u2013x;", "Wait(50);--x;", "a dash of a word processor")
        assertMended("if (x \u2264 3) Wait(5);", "if (x <= 3) Wait(5);", "a mathematical sign")
        assertMended("if (x \u2260 3) Wait(5);", "if (x != 3) Wait(5);", "a mathematical sign")
        assertMended("x = 3 \u00D7 4 \u00F7 2;", "x = 3 * 4 / 2;", "a mathematical sign")
        assertMended("PlaySound(SOUND_UP)\uFF1B", "PlaySound(SOUND_UP);", "a wide character")
        assertMended("\uFF37\uFF41\uFF49\uFF54\uFF08\uFF15\uFF10\uFF09\uFF1B", "Wait(50);", "a wide character")
        assertMended("if (x \uFF1D\uFF1D 3) Wait(5);", "if (x == 3) Wait(5);", "a wide character")
    }

    @Test
    fun `blanks of all kinds become spaces, all of a line at once`() {
        assertMended("OnFwd(OUT_A\u00A0+ OUT_C);", "OnFwd(OUT_A + OUT_C);", "a special space (U+00A0)")
        val many = "OnFwd(OUT_A\u2009+\u3000OUT_C);\u2003x++; // a\u00A0note"
        assertMended(many, "OnFwd(OUT_A + OUT_C); x++; // a\u00A0note", "a special space (U+2009)")
    }

    @Test
    fun `what cannot be seen is deleted, also within a word`() {
        assertMended("OnFwd(OUT_A);\u200B", "OnFwd(OUT_A);", "an invisible character (U+200B)")
        assertMended("On\u00ADFwd(OUT_A);", "OnFwd(OUT_A);", "an invisible character (U+00AD)")
    }

    @Test
    fun `the names of constants stand without quotation marks of any kind`() {
        for (name in listOf("\u201CSOUND_UP\u201D", "\u201ESOUND_UP\u201C", "\"SOUND_UP\"", "\u2018SOUND_UP\u2019")) {
            assertMended("PlaySound($name);", "PlaySound(SOUND_UP);", "Write SOUND_UP without quotation marks.")
        }
        val other = diagnosticsOf(inTask("PlaySound(\u201Chello\u201D);")).single()
        assertEquals(NqcDiagnosticCode.TEXT_AS_VALUE to null, other.code to other.fix)
    }

    @Test
    fun `the name of a file gets the quotation marks of NQC`() {
        val source = "#include \u201Cmy.nqh\u201D\n${inTask("Wait(5);")}"
        val options = NqcOptions(files = mapOf("my.nqh" to "int y;\n"))
        val found = diagnosticsOf(source, options).single()
        assertTrue("a curly quotation mark" in found.message, found.message)
        val mended = applied(source, checkNotNull(found.fix))
        assertEquals("#include \"my.nqh\"", mended.lines().first())
        assertIs<NqcResult.Success>(
            compileNqc("test.nqc", mended, options, messages = NqcMessages.of(Language.ENGLISH)),
        )
    }

    @Test
    fun `comments, texts for people and what a condition leaves out may have them`() {
        val source = "// it\u2019s \u2013 fine\n#warning it\u2019s new\u00A0\n#if 0\nx \u2264 \u201Cy\n#endif\n"
        assertEquals(
            listOf(NqcDiagnosticCode.WARNING_DIRECTIVE),
            diagnosticsOf(source + inTask("Wait(5);")).map { it.code },
        )
    }

    @Test
    fun `every line with pasted characters is told at once, beside other mistakes`() {
        val statements = "OnFwd(OUT_A\u00A0+ OUT_C);\n Wait(50); \u2013 \n PlaySound(SOUND_UP)\uFF1B\n go();"
        val source = "task main()\n{\n $statements\n}\n"
        assertEquals(listOf(3, 4, 5, 6), diagnosticsOf(source).map { it.range?.line })
    }

    private fun inTask(statement: String) = "int x;\ntask main()\n{\n    $statement\n}\n"

    private fun assertMended(statement: String, expected: String, named: String) {
        val found = diagnosticsOf(inTask(statement)).single()
        assertEquals(4, found.range?.line)
        assertTrue(named in found.message, found.message)
        val mended = applied(inTask(statement), checkNotNull(found.fix) { "$found" })
        assertEquals(inTask(expected), mended)
        assertIs<NqcResult.Success>(compileNqc("test.nqc", mended, messages = NqcMessages.of(Language.ENGLISH)), mended)
    }
}
