package robotran.ui.poster

import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.geometry.Point

/**
 * The part of the paper that a poster shows, in centimetres from the paper's upper left corner: what was drawn, with a
 * margin, and the robots near it. It has the ratio [aspect] of width to height, as far as the paper reaches. Without a
 * drawing it is the whole paper.
 */
internal fun cropOf(world: World, session: SessionState, aspect: Double): PosterArea {
    val paper = world.paper
    val drawn = boxOf(session.ink.strokes.flatMap { it.points })?.let { ink -> ink.with(robotsNear(ink, session)) }
        ?: return PosterArea(0.0, 0.0, paper.width, paper.height)
    val margin = maxOf(LEAST_MARGIN, maxOf(drawn.width, drawn.height) * MARGIN_PART)
    val box = drawn.grown(margin)
    val wide = maxOf(box.width, LEAST_SIDE)
    val high = maxOf(box.height, LEAST_SIDE)
    val width = minOf(maxOf(wide, high * aspect), paper.width)
    val height = minOf(maxOf(high, wide / aspect), paper.height)
    val left = (box.left + box.right - width) / 2
    val bottom = (box.bottom + box.top - height) / 2
    return PosterArea(
        left.coerceIn(0.0, paper.width - width),
        (paper.height - bottom - height).coerceIn(0.0, paper.height - height),
        width,
        height,
    )
}

/** Corners in centimetres from the paper's lower left corner, as the world has them. */
private class DrawnBox(val left: Double, val bottom: Double, val right: Double, val top: Double) {
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

/** The part of the drawing's longer side that is free around it. */
private const val MARGIN_PART = 0.08

/** Centimetres: around the drawing, across the whole, from the drawing to a robot, and around the middle of that. */
private const val LEAST_MARGIN = 2.0
private const val LEAST_SIDE = 20.0
private const val NEAR = 12.0
private const val ROBOT = 11.0
