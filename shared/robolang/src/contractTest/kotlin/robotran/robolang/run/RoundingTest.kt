package robotran.robolang.run

import robotran.robolang.robot.roundHalfUp
import kotlin.test.Test
import kotlin.test.assertEquals

class RoundingTest {
    @Test
    fun `a half is rounded up`() {
        assertEquals(1, roundHalfUp(0.5f))
        assertEquals(3, roundHalfUp(2.5f))
    }

    @Test
    fun `anything less than a half is rounded down`() {
        assertEquals(0, roundHalfUp(0.49999997f))
        assertEquals(8_388_609, roundHalfUp(8_388_609f))
    }

    @Test
    fun `what 32 bits cannot hold becomes the largest they can`() {
        assertEquals(Int.MAX_VALUE, roundHalfUp(1e20f))
    }
}
