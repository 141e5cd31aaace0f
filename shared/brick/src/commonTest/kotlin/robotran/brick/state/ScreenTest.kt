package robotran.brick.state

import kotlin.test.Test
import kotlin.test.assertEquals

class ScreenTest {
    private class Shown(override val lines: List<String>) : Screen {
        override val texts: List<String> get() = lines

        override fun shows(text: String): Boolean = text in lines
    }

    @Test
    fun `the text has all lines, without blank ones around them`() {
        assertEquals("a\n\nb", Shown(listOf("", "a", "", "b", "")).text)
        assertEquals("", Shown(List(8) { "" }).text)
    }
}
