package robotran.ui.sheet

import robotran.world.geometry.Point
import kotlin.math.PI
import kotlin.math.hypot
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class LitAreaTest {
    private val lamp = Point(10.0, 10.0)

    @Test
    fun `a lamp in the open shines on a disc`() {
        val area = litArea(lamp, 0.0, 360.0, 5.0, emptyList())
        assertTrue(area.all { hypot(it.x - 10, it.y - 10) in 4.999999..5.000001 })
        assertEquals(5 * 5 * PI, sizeOf(area), 0.3)
    }

    @Test
    fun `a cone is the part of the disc that its angle says`() {
        assertEquals(5 * 5 * PI / 4, sizeOf(litArea(lamp, 30.0, 90.0, 5.0, emptyList())), 0.1)
    }

    @Test
    fun `a lamp in a closed room shines on all of the room and no further`() {
        val room = listOf(Point(0.0, 0.0), Point(30.0, 0.0), Point(30.0, 20.0), Point(0.0, 20.0))
        assertEquals(600.0, sizeOf(litArea(lamp, 0.0, 360.0, 100.0, listOf(room))), 0.01)
    }

    @Test
    fun `behind a barrier there is a shadow with straight edges`() {
        val post = listOf(Point(14.0, 8.0), Point(15.0, 8.0), Point(15.0, 12.0), Point(14.0, 12.0))
        val room = listOf(Point(0.0, 0.0), Point(30.0, 0.0), Point(30.0, 20.0), Point(0.0, 20.0))
        // The triangle behind the post is 4 cm wide at a distance of 4 cm and 20 cm wide at the far wall, at 20 cm.
        val hidden = 20.0 * 20.0 / 2 - 4.0 * 4.0 / 2
        assertEquals(600.0 - hidden, sizeOf(litArea(lamp, 0.0, 360.0, 100.0, listOf(room, post))), 0.05)
    }

    private fun sizeOf(corners: List<Point>): Double {
        var twice = 0.0
        corners.forEachEdge { from, to -> twice += from.x * to.y - to.x * from.y }
        return twice / 2
    }
}
