package robotran.ui.sheet

import robotran.simulation.state.SessionState
import robotran.world.geometry.Point

/** Corners in centimetres from the paper's lower left corner, as the world has them. */
internal class DrawnBox(val left: Double, val bottom: Double, val right: Double, val top: Double) {
    val width: Double get() = right - left
    val height: Double get() = top - bottom

    fun grown(by: Double) = DrawnBox(left - by, bottom - by, right + by, top + by)

    fun with(others: List<DrawnBox>): DrawnBox = others.fold(this) { all, other ->
        DrawnBox(
            minOf(all.left, other.left),
            minOf(all.bottom, other.bottom),
            maxOf(all.right, other.right),
            maxOf(all.top, other.top),
        )
    }

    operator fun contains(point: Point) = point.x in left..right && point.y in bottom..top
}

/** The area of what was drawn, with the robots near it; null if nothing was. */
internal fun drawnBox(session: SessionState): DrawnBox? =
    boxOf(session.ink.strokes.flatMap { it.points })?.let { ink -> ink.with(robotsNear(ink, session)) }

private fun boxOf(points: List<Point>): DrawnBox? = if (points.isEmpty()) {
    null
} else {
    DrawnBox(points.minOf { it.x }, points.minOf { it.y }, points.maxOf { it.x }, points.maxOf { it.y })
}

/** A robot that has driven far away from its drawing would only make the drawing small. */
private fun robotsNear(ink: DrawnBox, session: SessionState): List<DrawnBox> {
    val near = ink.grown(NEAR)
    return session.robots.map { Point(it.robot.pose.x, it.robot.pose.y) }.filter { it in near }
        .map { DrawnBox(it.x, it.y, it.x, it.y).grown(ROBOT) }
}

/** Centimetres: from the drawing to a robot, and around the middle of that. */
private const val NEAR = 12.0
private const val ROBOT = 11.0
