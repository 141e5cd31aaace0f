package robotran.simulation.ink

import robotran.simulation.config.SimulationLimits
import robotran.simulation.state.TrailPiece
import robotran.world.geometry.Point

/** Records the paths of [robots] robots. */
internal class TrailWriter(robots: Int) {
    private val finished = GrowingList<TrailPiece>()
    private var finishedPoints = 0
    private val current = arrayOfNulls<StrokeWriter>(robots)
    private val last = arrayOfNulls<Point>(robots)
    private var snapshot: List<TrailPiece>? = emptyList()

    /** All pieces so far; the same list until a robot moves. */
    val pieces: List<TrailPiece>
        get() = snapshot
            ?: finished.view(current.mapIndexedNotNull { robot, way -> way?.let { TrailPiece(robot, it.points()) } })
                .also { snapshot = it }

    /** Records that a robot has moved to [x], [y]. */
    fun move(robot: Int, x: Double, y: Double) {
        val before = last[robot]
        if (before != null && before.x == x && before.y == y) return
        val place = Point(x, y)
        last[robot] = place
        if (!hasRoom()) return
        snapshot = null
        current[robot]?.moveTo(place) ?: run { current[robot] = StrokeWriter(place) }
    }

    /** Ends the piece of a robot that is picked up. */
    fun lift(robot: Int) {
        last[robot] = null
        val way = current[robot] ?: return
        current[robot] = null
        finished.add(TrailPiece(robot, way.points()))
        finishedPoints += way.size
    }

    private fun hasRoom() = finishedPoints + current.sumOf { it?.size ?: 0 } < SimulationLimits.MAXIMUM_TRAIL_POINTS
}
