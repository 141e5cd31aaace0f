package robotran.worldediting

import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import kotlin.math.max

/**
 * The shape after its handle at [side] was dragged to [to]: a rectangle keeps its opposite side, a circle its centre.
 */
internal fun Shape.resized(side: SizeSide, to: Point): Shape = when (this) {
    is Shape.Rectangle -> resizedRectangle(this, side, to)
    is Shape.Circle -> Shape.Circle(centre, max(radius(side, to), MIN_SIDE / 2))
    is Shape.Polygon -> this
}

private fun Shape.Circle.radius(side: SizeSide, to: Point): Double = when {
    side.up == 0 -> (to.x - centre.x) * side.across
    side.across == 0 -> (to.y - centre.y) * side.up
    else -> max((to.x - centre.x) * side.across, (to.y - centre.y) * side.up)
}

private fun resizedRectangle(rectangle: Shape.Rectangle, side: SizeSide, to: Point): Shape.Rectangle {
    val direction = Direction(rectangle.angle)
    val seen = relativeTo(rectangle.centre, direction, to)
    val width = stretched(rectangle.width, seen.x, side.across)
    val height = stretched(rectangle.height, seen.y, side.up)
    val centre = direction.from(
        rectangle.centre,
        (width - rectangle.width) / 2 * side.across,
        (height - rectangle.height) / 2 * side.up,
    )
    return rectangle.copy(centre = centre, width = width, height = height)
}

private fun stretched(side: Double, to: Double, towards: Int): Double =
    if (towards == 0) side else max(side / 2 + to * towards, MIN_SIDE)

/**
 * The scale factor for the contents of [frame] when its corner at [side] is dragged to [to] and the opposite corner
 * stays.
 */
internal fun factorFor(frame: SelectionFrame, side: SizeSide, to: Point): Double {
    val seen = frame.seen(to)
    val wide = if (frame.width > 0) HALF + seen.x * side.across / frame.width else 0.0
    val high = if (frame.height > 0) HALF + seen.y * side.up / frame.height else 0.0
    return max(max(wide, high), MIN_FACTOR)
}

/** Smaller sizes can only be typed. */
private const val MIN_SIDE = 0.5
private const val MIN_FACTOR = 0.05
private const val HALF = 0.5
