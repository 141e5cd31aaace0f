package robotran.world

/** Draws as the pen moves over the [paper]. */
internal class InkWriter(private val paper: Paper) {
    private val finished = GrowingList<InkStroke>()
    private var finishedPoints = 0
    private var current: StrokeWriter? = null
    private var last: Point? = null
    private var lengthCentimetres = 0.0
    private var snapshot: Ink? = Ink.NONE

    /** What has been drawn so far. */
    val ink: Ink
        get() = snapshot ?: Ink(finished.view(current?.stroke()), lengthCentimetres).also { snapshot = it }

    /** The pen is at [x], [y] now, having come there in a straight line; ink flows if its tip is [down] and there is paper under it. */
    fun move(x: Double, y: Double, down: Boolean) {
        if (!down || !paper.contains(x, y)) return lift()
        val before = last
        if (before != null && before.x == x && before.y == y) return
        val place = Point(x, y)
        last = place
        snapshot = null
        if (before == null) {
            if (hasRoom()) current = StrokeWriter(place)
        } else {
            lengthCentimetres += length(x - before.x, y - before.y)
            if (hasRoom()) current?.moveTo(place)
        }
    }

    private fun hasRoom() = finishedPoints + (current?.size ?: 0) < SimulationLimits.MAXIMUM_INK_POINTS

    private fun lift() {
        last = null
        val stroke = current ?: return
        finished.add(stroke.stroke())
        finishedPoints += stroke.size
        current = null
    }
}
