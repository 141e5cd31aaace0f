package robotran.textediting

import robotran.language.ProgramLanguage
import robotran.textediting.code.CodeTokenKind
import robotran.textediting.code.CodeTokens
import robotran.textediting.code.isJavaName
import robotran.textediting.code.renamedInJava
import robotran.textediting.code.tokenizeJavaLine
import robotran.textediting.code.tokensOf
import robotran.textediting.text.TextLines
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class CodeTokensTest {
    private fun described(line: String, language: ProgramLanguage) =
        tokensOf(line, language, startsInComment = false).map { it.kind to line.substring(it.start, it.end) }

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
    fun `a comment goes on until it ends`() {
        assertTrue(tokenizeJavaLine("a /* b", startsInComment = false).endsInComment)
        assertFalse(tokenizeJavaLine("b */ c", startsInComment = true).endsInComment)
        val tokens = CodeTokens(TextLines("/*\n int\n*/ int"), ProgramLanguage.JAVA)
        assertEquals(listOf(CodeTokenKind.COMMENT), tokens.of(1).map { it.kind })
        assertEquals(listOf(CodeTokenKind.COMMENT, CodeTokenKind.KEYWORD), tokens.of(2).map { it.kind })
    }

    @Test
    fun `a class is renamed wherever it is meant`() {
        val source = "class Square { // Square\n  Square next = new Square(\"Square\");\n  int Squares;\n}"
        assertEquals(
            "class Box { // Square\n  Box next = new Box(\"Square\");\n  int Squares;\n}",
            renamedInJava(source, "Square", "Box"),
        )
        assertTrue(isJavaName("Box2"))
        assertFalse(isJavaName("2Box") || isJavaName("class") || isJavaName("a b") || isJavaName(""))
    }
}
