package robotran.desktop

import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class RehearsalTest {
    @Test
    fun `a start can be gone through without a display, and all that it names is there`() {
        assertTrue(Rehearsal.NEEDS_DISPLAY.isNotEmpty())
        Rehearsal.main(emptyArray())
        assertFalse(hasDisplay())
    }
}
