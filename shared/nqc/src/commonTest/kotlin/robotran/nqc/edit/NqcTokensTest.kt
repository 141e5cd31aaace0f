package robotran.nqc.edit

import robotran.languagesupport.BlockEffect
import robotran.languagesupport.CodeToken
import robotran.languagesupport.CodeTokenKind
import robotran.nqc.Vectors
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class NqcTokensTest {
    @Test
    fun `words and signs have their kinds`() {
        val line = "  #define GO(x) OnFwd(x); // go"
        assertEquals(
            "KEYWORD:#define NAME:GO SIGN:( NAME:x SIGN:) BUILT_IN:OnFwd SIGN:( NAME:x SIGN:) SIGN:; COMMENT:// go",
            shown(line),
        )
        assertEquals("KEYWORD:if SIGN:( BUILT_IN:SENSOR_1 SIGN:!= NUMBER:0x1f SIGN:)", shown("if (SENSOR_1 != 0x1f)"))
        assertEquals("KEYWORD:#include TEXT:\"a.nqh\"", shown("#include \"a.nqh\""))
    }

    @Test
    fun `comments go over lines`() {
        val first = nqcTokens("int x; /* begins", startsInComment = false)
        assertTrue(first.endsInComment)
        val second = nqcTokens("ends */ int y;", first.endsInComment)
        assertEquals(CodeToken(CodeTokenKind.COMMENT, 0, 7), second.tokens.first())
        assertEquals(4, second.tokens.size)
        assertTrue(!second.endsInComment)
    }

    @Test
    fun `tokens never overlap`() {
        for (source in Vectors.programs.values) {
            var isInComment = false
            for (line in source.lines()) {
                val tokens = nqcTokens(line, isInComment)
                isInComment = tokens.endsInComment
                assertTrue(tokens.tokens.zipWithNext().all { (first, second) -> first.end <= second.start }, line)
            }
        }
    }

    @Test
    fun `braces indent`() {
        assertEquals(BlockEffect(closes = false, opens = true), NqcSyntax.blockEffect("task main() {"))
        assertEquals(BlockEffect(closes = true, opens = true), NqcSyntax.blockEffect("  } else {"))
        assertEquals(BlockEffect(closes = false, opens = false), NqcSyntax.blockEffect("void f() { } // {"))
    }

    private fun shown(line: String) = nqcTokens(line, startsInComment = false).tokens
        .joinToString(" ") { "${it.kind}:${line.substring(it.start, it.end)}" }
}
