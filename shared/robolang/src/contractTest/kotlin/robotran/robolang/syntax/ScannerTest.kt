package robotran.robolang.syntax

import robotran.language.Language
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.words.Keyword
import robotran.robolang.words.Vocabulary
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class ScannerTest {
    @Test
    fun `a line becomes tokens with their places`() {
        val line = scan("  forward -2.5cm // ahead").single()
        assertEquals(
            listOf(
                Token(TokenKind.WORD, SourceRange(1, 3, 10), "forward", Keyword.FORWARD),
                Token(TokenKind.MINUS, SourceRange(1, 11, 12), "-"),
                Token(TokenKind.NUMBER, SourceRange(1, 12, 15), "2.5"),
                Token(TokenKind.WORD, SourceRange(1, 15, 17), "cm", Keyword.CM),
            ),
            line.tokens,
        )
        assertEquals(Token(TokenKind.COMMENT, SourceRange(1, 18, 26), "// ahead"), line.comment)
    }

    @Test
    fun `a word keeps the way it is typed`() {
        val word = scan("RePeat_2").single().tokens.single()
        assertEquals("RePeat_2", word.text)
        assertNull(word.keyword)
        assertEquals(Keyword.REPEAT, scan("RePeat").single().tokens.single().keyword)
    }

    @Test
    fun `a letter that only looks like one of a keyword is not`() {
        assertNull(Vocabulary.ENGLISH.keyword("bac\u212Award"))
    }

    @Test
    fun `the tree keeps every comment`() {
        val diagnostics = DiagnosticSink(RobolangMessages.of(Language.ENGLISH))
        val tree = Parser(scan("// one\nbeep // two\n\n//", diagnostics), diagnostics).program().tree
        assertEquals(listOf("// one", "// two", "//"), tree.comments.map { it.text })
        assertEquals(listOf(1, 2, 4), tree.comments.map { it.range?.line })
    }

    private fun scan(source: String): List<ScannedLine> =
        scan(source, DiagnosticSink(RobolangMessages.of(Language.ENGLISH)))
}
