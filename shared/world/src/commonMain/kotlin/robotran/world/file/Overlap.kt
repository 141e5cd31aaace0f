package robotran.world.file

import robotran.world.Point
import robotran.world.Shape
import robotran.world.distance

/** Whether two edges of the polygon cross or touch where they are not neighbours, or neighbours fold back onto each other. */
internal fun edgesCross(corners: List<Point>): Boolean {
    val count = corners.size
    for (one in 0..<count) {
        val from = corners[one]
        val to = corners[(one + 1) % count]
        if (from == to) return true
        for (other in one + 1..<count) {
            val otherFrom = corners[other]
            val otherTo = corners[(other + 1) % count]
            val crosses = when {
                other == one + 1 -> foldsBack(from, to, otherTo)
                one == 0 && other == count - 1 -> foldsBack(otherFrom, from, to)
                else -> meet(from, to, otherFrom, otherTo)
            }
            if (crosses) return true
        }
    }
    return false
}

/** Whether two shapes, given as [flat], cover a common place; not if they only touch. */
internal fun overlap(one: Flat, other: Flat): Boolean = when {
    one is Flat.Round && other is Flat.Round -> within(one.centre, other.centre, one.radius + other.radius)
    one is Flat.Round -> overlap(other as Flat.Angular, one)
    other is Flat.Round -> overlap(one as Flat.Angular, other)
    else -> overlap(one as Flat.Angular, other as Flat.Angular)
}

/** A shape with its angle worked out. */
internal sealed interface Flat {
    class Round(val centre: Point, val radius: Double) : Flat

    class Angular(val corners: List<Point>) : Flat
}

internal fun flat(shape: Shape): Flat = when (shape) {
    is Shape.Circle -> {
        Flat.Round(shape.centre, shape.radius)
    }

    is Shape.Polygon -> {
        Flat.Angular(shape.corners)
    }

    is Shape.Rectangle -> {
        val halfWidth = shape.width / 2
        val halfHeight = shape.height / 2
        box(shape.centre, Direction(shape.angle), -halfWidth..halfWidth, -halfHeight..halfHeight)
    }
}

/** What lies so far ahead and to the left of [origin]. */
internal fun box(origin: Point, direction: Direction, along: ClosedRange<Double>, across: ClosedRange<Double>) = Flat.Angular(
    listOf(
        direction.from(origin, along.start, across.start),
        direction.from(origin, along.endInclusive, across.start),
        direction.from(origin, along.endInclusive, across.endInclusive),
        direction.from(origin, along.start, across.endInclusive),
    ),
)

private fun overlap(one: Flat.Angular, other: Flat.Round): Boolean =
    contains(one.corners, other.centre) || edges(one.corners).any { (from, to) -> distance(other.centre, from, to) < other.radius }

private fun overlap(one: Flat.Angular, other: Flat.Angular): Boolean =
    contains(one.corners, other.corners.first()) || contains(other.corners, one.corners.first()) ||
        edges(one.corners).any { (from, to) -> edges(other.corners).any { (otherFrom, otherTo) -> cross(from, to, otherFrom, otherTo) } }

private fun edges(corners: List<Point>): List<Pair<Point, Point>> = corners.indices.map { corners[it] to corners[(it + 1) % corners.size] }

private fun within(one: Point, other: Point, reach: Double): Boolean = distance(one, other, other) < reach

/** By counting the edges to the right. */
private fun contains(corners: List<Point>, place: Point): Boolean = edges(corners).count { (from, to) ->
    (from.y > place.y) != (to.y > place.y) && place.x < (to.x - from.x) * (place.y - from.y) / (to.y - from.y) + from.x
} % 2 == 1

/** Positive if [place] is to the left of the way from [from] to [to], zero if it is on it. */
private fun side(from: Point, to: Point, place: Point): Double =
    (to.x - from.x) * (place.y - from.y) - (to.y - from.y) * (place.x - from.x)

private fun foldsBack(from: Point, corner: Point, to: Point): Boolean =
    side(from, corner, to) == 0.0 && (corner.x - from.x) * (to.x - corner.x) + (corner.y - from.y) * (to.y - corner.y) < 0

/** Whether two lines cross each other in the middle. */
private fun cross(from: Point, to: Point, otherFrom: Point, otherTo: Point): Boolean =
    side(from, to, otherFrom) * side(from, to, otherTo) < 0 && side(otherFrom, otherTo, from) * side(otherFrom, otherTo, to) < 0

/** Whether two lines have a place in common. */
private fun meet(from: Point, to: Point, otherFrom: Point, otherTo: Point): Boolean =
    cross(from, to, otherFrom, otherTo) || isOn(from, to, otherFrom) || isOn(from, to, otherTo) ||
        isOn(otherFrom, otherTo, from) || isOn(otherFrom, otherTo, to)

private fun isOn(from: Point, to: Point, place: Point): Boolean =
    side(from, to, place) == 0.0 && place.x in minOf(from.x, to.x)..maxOf(from.x, to.x) &&
        place.y in minOf(from.y, to.y)..maxOf(from.y, to.y)
