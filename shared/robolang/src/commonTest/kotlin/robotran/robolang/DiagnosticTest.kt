package robotran.robolang

import robotran.language.Language
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.RobolangLimits
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class DiagnosticTest {
    @Test
    fun `a mistake has its code, range and text`() {
        val diagnostic = errorsOf("pen down\n  turn lfet 90").single()
        assertEquals(DiagnosticCode.MISSING_TURN_DIRECTION, diagnostic.code)
        assertEquals(SourceRange(line = 2, column = 8, endColumn = 12), diagnostic.range)
        assertEquals("lfet", diagnostic.text)
    }

    @Test
    fun `what is missing has no width and no text`() {
        val diagnostic = errorsOf("forward   // how far").single()
        assertEquals(SourceRange(line = 1, column = 8, endColumn = 8), diagnostic.range)
        assertEquals("", diagnostic.text)
    }

    @Test
    fun `what is quoted keeps the way it is typed`() {
        assertEquals("fOward", errorsOf("fOward 3").single().text)
        assertEquals("very   fast", errorsOf("forward 3 very   fast").single().text)
        assertEquals("-2.50", errorsOf("repeat -2.50 times\nend").single().text)
    }

    @Test
    fun `every line end counts as one`() {
        for (lineEnd in listOf("\n", "\r\n", "\r")) {
            val diagnostics = errorsOf("beep${lineEnd}hop${lineEnd}${lineEnd}skip$lineEnd")
            assertEquals(listOf(2, 4), diagnostics.map { it.range?.line })
        }
    }

    @Test
    fun `a byte order mark does not count as a character`() {
        assertEquals(emptyList(), errorsOf("\uFEFFbeep"))
        assertEquals(1, errorsOf("\uFEFFhop").single().range?.column)
    }

    @Test
    fun `a byte order mark anywhere else cannot be seen`() {
        val diagnostic = errorsOf("beep\n\uFEFFbeep").single()
        assertEquals(DiagnosticCode.UNKNOWN_CHARACTER, diagnostic.code)
        assertTrue("U+FEFF" in diagnostic.message)
    }

    @Test
    fun `half a character is told by its number`() {
        assertTrue("U+D83E" in errorsOf("beep \uD83E").single().message)
    }

    @Test
    fun `a character of two halves is one mistake`() {
        val diagnostic = errorsOf("beep \uD83E\uDD16").single()
        assertEquals(SourceRange(line = 1, column = 6, endColumn = 8), diagnostic.range)
        assertEquals("\uD83E\uDD16", diagnostic.text)
    }

    @Test
    fun `a source that is too long is refused as a whole`() {
        val longest = "/".repeat(RobolangLimits.SOURCE_CHARACTERS)
        assertEquals(emptyList(), errorsOf(longest))
        val diagnostic = errorsOf("$longest/").single()
        assertEquals(DiagnosticCode.SOURCE_TOO_LONG, diagnostic.code)
        assertEquals("A program can have at most 1000000 characters. This one has more.", diagnostic.message)
    }

    @Test
    fun `codes are all different`() {
        assertEquals(DiagnosticCode.entries.size, DiagnosticCode.entries.map { it.id }.toSet().size)
    }

    @Test
    fun `the messages can be in another language`() {
        val german = object : RobolangMessages by RobolangMessages.of(Language.ENGLISH) {
            override fun extraEnd() = "Dieses \"end\" schließt nichts."
        }
        val result = compileRobolang("test", "end", testTarget, german) as RobolangResult.Failure
        assertEquals("Dieses \"end\" schließt nichts.", result.diagnostics.single().message)
    }
}
