package robotran.simulation.ink

import robotran.simulation.config.SimulationLimits
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.world.Paper
import robotran.world.geometry.Point
import robotran.world.geometry.length

/** Draws as the pens of [robots] robots move over the [paper]. */
internal class InkWriter(private val paper: Paper, robots: Int) {
    private val finished = GrowingList<InkStroke>()
    private var finishedPoints = 0
    private val pens = List(robots) { Pen(it) }
    private var lengthCentimetres = 0.0
    private var snapshot: Ink? = Ink.NONE

    val ink: Ink
        get() = snapshot
            ?: Ink(finished.view(pens.mapNotNull { it.stroke() }), lengthCentimetres).also { snapshot = it }

    /**
     * Moves the pen of a robot to [x], [y] in a straight line; ink flows if its tip is [down] and there is paper under
     * it. Returns the segment drawn, or null.
     */
    fun move(robot: Int, x: Double, y: Double, down: Boolean): Pair<Point, Point>? {
        if (!down || !paper.contains(x, y)) {
            lift(robot)
            return null
        }
        return pens[robot].move(Point(x, y))
    }

    /** Lifts the pen of a robot off the paper. */
    fun lift(robot: Int) = pens[robot].lift()

    private fun hasRoom() = finishedPoints + pens.sumOf { it.size } < SimulationLimits.MAXIMUM_INK_POINTS

    private inner class Pen(private val robot: Int) {
        private var current: StrokeWriter? = null
        private var last: Point? = null

        val size: Int get() = current?.size ?: 0

        fun stroke(): InkStroke? = current?.stroke(robot)

        fun move(point: Point): Pair<Point, Point>? {
            val before = last
            if (before == point) return null
            last = point
            snapshot = null
            if (before == null) {
                if (hasRoom()) current = StrokeWriter(point)
                return point to point
            }
            lengthCentimetres += length(point.x - before.x, point.y - before.y)
            if (hasRoom()) current?.moveTo(point)
            return before to point
        }

        fun lift() {
            last = null
            val stroke = current ?: return
            finished.add(stroke.stroke(robot))
            finishedPoints += stroke.size
            current = null
        }
    }
}
