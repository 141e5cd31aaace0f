package robotran.language

import kotlin.test.Test
import kotlin.test.assertEquals

class VisibleTextTest {
    @Test
    fun `what a terminal would obey is seen`() {
        assertEquals("\\u001b[31mred\\u001b]0;title\\u0007", visibleText("\u001B[31mred\u001B]0;title\u0007"))
        assertEquals("a\\u0008b\\u007fc\\u009bd\\u0000", visibleText("a\bb\u007Fc\u009Bd\u0000"))
        assertEquals("over\\u000dwritten", visibleText("over\rwritten"))
    }

    @Test
    fun `what turns the direction of a line is seen`() {
        assertEquals("a\\u202eb\\u2066c\\u2028d", visibleText("a\u202Eb\u2066c\u2028d"))
    }

    @Test
    fun `half a character is seen`() {
        assertEquals("\\ud83ea\\udd16", visibleText("\uD83Ea\uDD16"))
    }

    @Test
    fun `all else stays, line ends and tabs too`() {
        val text = "ñ\tשלום\u200F 🤖 👩‍🏫\r\nnext\n"
        assertEquals(text, visibleText(text))
    }

    @Test
    fun `in one line, line ends and tabs are seen too`() {
        assertEquals("a\\u000d\\u000ab\\u0009🤖", visibleLine("a\r\nb\t🤖"))
    }
}
