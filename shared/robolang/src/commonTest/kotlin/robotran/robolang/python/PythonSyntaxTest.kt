package robotran.robolang.python

import robotran.brick.kind.BrickKind
import robotran.languagesupport.CodeTokenKind
import kotlin.test.Test
import kotlin.test.assertEquals

class PythonSyntaxTest {
    private fun tokensOf(line: String) = PythonSyntax.tokens(line, startsInComment = false, BrickKind.default).tokens
        .map { line.substring(it.start, it.end) to it.kind }

    @Test
    fun `words numbers texts and comments have colours of their own`() {
        val expected = listOf(
            "while" to CodeTokenKind.KEYWORD,
            "größe" to CodeTokenKind.NAME,
            "<" to CodeTokenKind.SIGN,
            "2.5" to CodeTokenKind.NUMBER,
            ":" to CodeTokenKind.SIGN,
            "# more" to CodeTokenKind.COMMENT,
        )
        assertEquals(expected, tokensOf("while größe < 2.5:  # more"))
        assertEquals("\"a # \\\" b\"" to CodeTokenKind.TEXT, tokensOf("print(\"a # \\\" b\")")[2])
        assertEquals(CodeTokenKind.BUILT_IN, tokensOf("left_motor = Motor(Port.A)")[2].second)
    }

    @Test
    fun `a text without its end goes to the end of the line`() {
        assertEquals(listOf("\"ab" to CodeTokenKind.TEXT), tokensOf("\"ab"))
    }
}
