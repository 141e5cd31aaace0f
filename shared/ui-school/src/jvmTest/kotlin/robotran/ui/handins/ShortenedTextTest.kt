package robotran.ui.handins

import kotlin.test.Test
import kotlin.test.assertEquals

class ShortenedTextTest {
    private fun shortened(label: String, room: Int) = shortenedInMiddle(label) { it.length <= room }

    @Test
    fun `what fits is left as it is`() = assertEquals("Änne.robotran", shortened("Änne.robotran", 13))

    @Test
    fun `the end of a long name, which is the pupil's, stays`() =
        assertEquals("To the wi…- Änne.robotran", shortened("To the wide flag at the wall - Änne.robotran", 25))

    @Test
    fun `signs of two letters are not cut`() {
        val shown = shortened("😀".repeat(20), 10)
        assertEquals(shown.count { it.isHighSurrogate() }, shown.count { it.isLowSurrogate() })
    }

    @Test
    fun `without any room a sign is left`() = assertEquals("…", shortened("Änne", 0))
}
