package robotran.simulation.light

import robotran.simulation.noise.NoiseStream
import robotran.world.Paper
import robotran.world.geometry.Point
import robotran.world.geometry.distance
import kotlin.math.sqrt
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class CapsuleTest {
    private val random = NoiseStream(1, "capsules")

    @Test
    fun `a capsule contains the points that are near enough to the last bit`() {
        for (radius in listOf(0.0, 0.15, 0.25, 1.0, 0.1 * 3)) {
            val limit = squareLimit(radius)
            repeat(20_000) {
                val (from, to, place) = List(3) { Point(coordinate(), coordinate()) }
                assertEquals(
                    distance(place, from, to) <= radius,
                    Capsule(from, to, limit).contains(place.x, place.y),
                    "$place, $from to $to, $radius",
                )
            }
        }
    }

    @Test
    fun `the limit of squares is the largest number with a root that is small enough`() {
        repeat(1_000) {
            val distance = 3 * random.share()
            val limit = squareLimit(distance)
            assertTrue(sqrt(limit) <= distance)
            assertTrue(sqrt(Double.fromBits(limit.toRawBits() + 1)) > distance)
        }
    }

    @Test
    fun `ink reaches beyond all edges of the paper`() {
        val paper = Paper(6.4, 3.2)
        val ink = InkRaster(paper)
        val corners = listOf(Point(0.0, 0.0), Point(6.4, 0.0), Point(6.4, 3.2), Point(0.0, 3.2))
        assertFalse(ink.mayHave(-9.0, -9.0, 9.0, 9.0))
        corners.indices.forEach { ink.draw(corners[it], corners[(it + 1) % corners.size]) }
        for (corner in corners) assertTrue(ink.has(corner.x, corner.y), "$corner")
        for ((x, y) in listOf(-0.12 to 1.0, 6.52 to 1.0, 3.0 to -0.12, 3.0 to 3.32)) assertTrue(ink.has(x, y), "$x $y")
        for ((x, y) in listOf(-0.2 to 1.0, 6.6 to 1.0, 1e9 to -1e9, 3.0 to 1.6)) assertFalse(ink.has(x, y), "$x $y")
        assertFalse(ink.mayHave(-1e9, -1e9, -1e9, -1e9))
    }

    /** Often a multiple of an eighth, so that some points lie exactly on the edge. */
    private fun coordinate() = if (random.share() < 0.5) (random.share() * 8).toInt() / 8.0 else random.share()
}
