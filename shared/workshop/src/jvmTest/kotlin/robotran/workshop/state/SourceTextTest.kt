package robotran.workshop.state

import robotran.robolang.diagnostic.SourceFix
import robotran.robolang.diagnostic.SourceRange
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class SourceTextTest {
    @Test
    fun `a fix replaces what it names`() {
        assertEquals(
            "beep\nforward 3\nbeep",
            "beep\nforwrd 3\nbeep".withFix(SourceFix(SourceRange(2, 1, 7), "forward")),
        )
    }

    @Test
    fun `a fix without width puts something in, also at the end of the text`() {
        assertEquals("wait 3 seconds", "wait 3".withFix(SourceFix(SourceRange(1, 7, 7), " seconds")))
    }

    @Test
    fun `a fix for a place that is no longer there changes nothing`() {
        assertEquals("beep", "beep".withFix(SourceFix(SourceRange(2, 1, 3), "x")))
        assertEquals("beep", "beep".withFix(SourceFix(SourceRange(1, 3, 9), "x")))
    }

    @Test
    fun `offsets count from the beginning of the text`() {
        assertEquals(0, "".offsetOf(1, 1))
        assertEquals(3, "a\nbc".offsetOf(2, 2))
        assertNull("a\nbc".offsetOf(1, 3))
        assertNull("a\nbc".offsetOf(3, 1))
    }

    @Test
    fun `every way to end a line becomes one`() {
        assertEquals("a\nb\nc\nd", "a\r\nb\rc\nd".withPlainLineEnds())
    }
}
