package robotran.simulation

import robotran.simulation.config.SimulationLimits
import robotran.simulation.ink.InkWriter
import robotran.simulation.state.Ink
import robotran.world.Paper
import robotran.world.geometry.Point
import robotran.world.geometry.distance
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class InkWriterTest {
    private val paper = Paper(1000.0, 1000.0)

    private fun draw(places: List<Point>): Ink {
        val writer = InkWriter(paper, robots = 1)
        places.forEach { writer.move(0, it.x, it.y, down = true) }
        return writer.ink
    }

    @Test
    fun `a corner is kept`() {
        val there = (0..100).map { Point(it / 10.0, 5.0) }
        val up = (1..100).map { Point(10.0, 5.0 + it / 10.0) }
        assertEquals(
            listOf(Point(0.0, 5.0), Point(10.0, 5.0), Point(10.0, 15.0)),
            draw(there + up).strokes.single().points,
        )
    }

    @Test
    fun `the far end of a line drawn back and forth is kept`() {
        val places = ((0..100) + (99 downTo 20)).map { Point(it / 10.0, 5.0) }
        val ink = draw(places)
        assertEquals(listOf(0.0, 10.0, 2.0), ink.strokes.single().points.map { it.x })
        assertEquals(18.0, ink.lengthCentimetres, 1e-9)
    }

    @Test
    fun `every place of a bent line lies on the drawn line`() {
        val places = (0..500).map { Point(it * 0.05, it * it * 0.0001) }
        val points = draw(places).strokes.single().points
        places.forEach { place ->
            val nearest = points.zipWithNext { from, to -> distance(place, from, to) }.min()
            assertTrue(nearest <= SimulationLimits.INK_TOLERANCE * 1.001, "$place is $nearest from the line")
        }
        assertTrue(points.size < places.size / 5, "${points.size} points")
    }

    @Test
    fun `a pen put down in place leaves a dot`() {
        assertEquals(listOf(Point(3.0, 4.0)), draw(List(10) { Point(3.0, 4.0) }).strokes.single().points)
    }

    @Test
    fun `drawing without end keeps the oldest and goes on measuring`() {
        val writer = InkWriter(paper, robots = 1)
        val moves = SimulationLimits.MAXIMUM_INK_POINTS + 1000
        repeat(moves) { writer.move(0, it % 2 * 1.0, it % 3 * 1.0, down = true) }
        val ink = writer.ink
        assertEquals(SimulationLimits.MAXIMUM_INK_POINTS, ink.strokes.sumOf { it.points.size })
        assertEquals(Point(0.0, 0.0), ink.strokes.first().points.first())
        assertTrue(ink.lengthCentimetres > moves)
    }
}
