package robotran.desktop.platform

import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class SystemMotionTest {
    @Test
    fun `a Mac reduces motion if its switch is on`() {
        assertTrue(isReducedOnMac("1\n"))
        assertFalse(isReducedOnMac("0\n"))
        assertFalse(isReducedOnMac(""))
    }

    @Test
    fun `Windows reduces motion if its animation effects are off`() {
        assertFalse(isReducedOnWindows(answer("9E1E078012000000")))
        assertTrue(isReducedOnWindows(answer("9E1E078010000000")))
        assertFalse(isReducedOnWindows("ERROR: The system was unable to find the specified registry key or value."))
    }

    private fun answer(mask: String) =
        "\r\nHKEY_CURRENT_USER\\Control Panel\\Desktop\r\n    UserPreferencesMask    REG_BINARY    $mask\r\n\r\n"
}
