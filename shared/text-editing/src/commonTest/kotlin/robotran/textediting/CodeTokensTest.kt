package robotran.textediting

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.CodeTokens
import robotran.languagesupport.TextLines
import robotran.programs.support
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class CodeTokensTest {
    private val java = ProgramLanguage.JAVA.support

    private fun described(line: String, language: ProgramLanguage) =
        language.support.code.tokens(line, startsInComment = false, brick = BrickKind.RCX).tokens.map {
            it.kind to
                line.substring(it.start, it.end)
        }

    @Test
    fun `a line of Robolang is taken apart as its scanner does`() = assertEquals(
        listOf(
            CodeTokenKind.KEYWORD to "show",
            CodeTokenKind.BUILT_IN to "abs",
            CodeTokenKind.SIGN to "(",
            CodeTokenKind.NAME to "side",
            CodeTokenKind.SIGN to ")",
            CodeTokenKind.COMMENT to "// how long",
        ),
        described("show abs(side) // how long", ProgramLanguage.ROBOLANG),
    )

    @Test
    fun `a line of Java is taken apart`() = assertEquals(
        listOf(
            CodeTokenKind.KEYWORD to "int",
            CodeTokenKind.NAME to "x",
            CodeTokenKind.SIGN to "=",
            CodeTokenKind.BUILT_IN to "Motor",
            CodeTokenKind.SIGN to ".",
            CodeTokenKind.NAME to "A",
            CodeTokenKind.SIGN to "+",
            CodeTokenKind.NUMBER to "0x1F",
            CodeTokenKind.SIGN to ";",
            CodeTokenKind.COMMENT to "/* a */",
            CodeTokenKind.TEXT to "\"\\\"b\"",
            CodeTokenKind.COMMENT to "// c",
        ),
        described("int x = Motor.A + 0x1F; /* a */ \"\\\"b\" // c", ProgramLanguage.JAVA),
    )

    @Test
    fun `a line of NQC is taken apart`() = assertEquals(
        listOf(
            CodeTokenKind.KEYWORD to "while",
            CodeTokenKind.SIGN to "(",
            CodeTokenKind.BUILT_IN to "SENSOR_1",
            CodeTokenKind.SIGN to "==",
            CodeTokenKind.NAME to "border",
            CodeTokenKind.SIGN to ")",
            CodeTokenKind.BUILT_IN to "Wait",
            CodeTokenKind.SIGN to "(",
            CodeTokenKind.NUMBER to "10",
            CodeTokenKind.SIGN to ")",
            CodeTokenKind.SIGN to ";",
            CodeTokenKind.COMMENT to "// so",
        ),
        described("while (SENSOR_1 == border) Wait(10); // so", ProgramLanguage.NQC),
    )

    @Test
    fun `a line of assembly text is taken apart`() {
        assertEquals(
            listOf(
                CodeTokenKind.NAME to "again",
                CodeTokenKind.SIGN to ":",
                CodeTokenKind.BUILT_IN to "wait",
                CodeTokenKind.NUMBER to "2",
                CodeTokenKind.SIGN to ",",
                CodeTokenKind.NUMBER to "-5",
                CodeTokenKind.COMMENT to "; so",
            ),
            described("again: wait 2, -5 ; so", ProgramLanguage.LASM),
        )
        assertEquals(
            listOf(CodeTokenKind.KEYWORD to "task", CodeTokenKind.NUMBER to "0x1F"),
            described("\ttask\t0x1F", ProgramLanguage.LASM),
        )
    }

    @Test
    fun `a comment of NQC goes on until it ends`() {
        val tokens =
            CodeTokens(TextLines("/*\n int\n*/ int"), ProgramLanguage.NQC.support.code, otherwise = BrickKind.RCX)
        assertEquals(listOf(CodeTokenKind.COMMENT), tokens.of(1).map { it.kind })
        assertEquals(listOf(CodeTokenKind.COMMENT, CodeTokenKind.KEYWORD), tokens.of(2).map { it.kind })
    }

    @Test
    fun `a comment goes on until it ends`() {
        assertTrue(java.code.tokens("a /* b", startsInComment = false, brick = BrickKind.RCX).endsInComment)
        assertFalse(java.code.tokens("b */ c", startsInComment = true, brick = BrickKind.RCX).endsInComment)
        val tokens =
            CodeTokens(TextLines("/*\n int\n*/ int"), ProgramLanguage.JAVA.support.code, otherwise = BrickKind.RCX)
        assertEquals(listOf(CodeTokenKind.COMMENT), tokens.of(1).map { it.kind })
        assertEquals(listOf(CodeTokenKind.COMMENT, CodeTokenKind.KEYWORD), tokens.of(2).map { it.kind })
    }

    @Test
    fun `a class is renamed wherever it is meant`() {
        val source = "class Square { // Square\n  Square next = new Square(\"Square\");\n  int Squares;\n}"
        assertEquals(
            "class Box { // Square\n  Box next = new Box(\"Square\");\n  int Squares;\n}",
            java.files.renamed(source, "Square", "Box"),
        )
        assertTrue(java.files.isValidName("Box2"))
        assertFalse(
            java.files.isValidName("2Box") || java.files.isValidName("class") || java.files.isValidName("a b") ||
                java.files.isValidName(""),
        )
    }
}
