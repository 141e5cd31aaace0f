package robotran.workshop.state

import kotlin.test.Test
import kotlin.test.assertEquals

class SourceTextTest {
    @Test
    fun `every way to end a line becomes one`() {
        assertEquals("a\nb\nc\nd", "a\r\nb\rc\nd".withPlainLineEnds())
    }
}
