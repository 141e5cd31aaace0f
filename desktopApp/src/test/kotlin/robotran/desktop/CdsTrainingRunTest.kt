package robotran.desktop

import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class CdsTrainingRunTest {
    @Test
    fun `a start can be gone through without a display, and all that it names is there`() {
        assertTrue(CdsTrainingRun.NEEDS_DISPLAY.isNotEmpty())
        CdsTrainingRun.main(emptyArray())
        assertFalse(hasDisplay())
    }
}
