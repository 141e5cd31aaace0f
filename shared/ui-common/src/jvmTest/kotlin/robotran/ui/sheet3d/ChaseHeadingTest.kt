package robotran.ui.sheet3d

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class ChaseHeadingTest {
    @Test
    fun `it begins behind the robot and comes after it when it turns`() {
        val chase = ChaseHeading()
        assertEquals(90.0, chase.at(90.0, 0))
        val first = chase.at(180.0, 100)
        assertTrue(first in 100.0..120.0, "$first")
        val later = (2L..40L).map { chase.at(180.0, it * 100) }
        assertTrue(later.zipWithNext().all { (one, next) -> next >= one })
        assertEquals(180.0, later.last(), 0.1)
    }

    @Test
    fun `it takes the shorter way round`() {
        val chase = ChaseHeading()
        chase.at(170.0, 0)
        assertTrue(chase.at(-170.0, 100) > 170.0)
    }

    @Test
    fun `after a jump in time it is behind the robot at once`() {
        val chase = ChaseHeading()
        chase.at(0.0, 5_000)
        assertEquals(90.0, chase.at(90.0, 1_000))
        assertEquals(45.0, chase.at(45.0, 60_000))
    }
}
