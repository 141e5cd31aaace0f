package robotran.world.geometry

/** Whether two non-adjacent edges of the polygon cross or touch, or adjacent ones fold back onto each other. */
fun edgesCross(corners: List<Point>): Boolean {
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

/** Whether two shapes, given as [flat], have a common area; false if they only touch. */
fun overlap(one: Outline, other: Outline): Boolean = when {
    one is Outline.Round && other is Outline.Round -> within(one.centre, other.centre, one.radius + other.radius)
    one is Outline.Round -> overlap(other as Outline.Angular, one)
    other is Outline.Round -> overlap(one as Outline.Angular, other)
    else -> overlap(one as Outline.Angular, other as Outline.Angular)
}

/** Same as [Shape.outline], without the physics engine. */
fun flat(shape: Shape): Outline = when (shape) {
    is Shape.Circle -> Outline.Round(shape.centre, shape.radius)
    is Shape.Polygon -> Outline.Angular(shape.corners)

    is Shape.Rectangle -> {
        val halfWidth = shape.width / 2
        val halfHeight = shape.height / 2
        box(shape.centre, Direction(shape.angle), -halfWidth..halfWidth, -halfHeight..halfHeight)
    }
}

/** The rectangle at these distances ahead of [origin] and to the left of it. */
internal fun box(origin: Point, direction: Direction, along: ClosedRange<Double>, across: ClosedRange<Double>) =
    Outline.Angular(
        listOf(
            direction.from(origin, along.start, across.start),
            direction.from(origin, along.endInclusive, across.start),
            direction.from(origin, along.endInclusive, across.endInclusive),
            direction.from(origin, along.start, across.endInclusive),
        ),
    )

private fun overlap(one: Outline.Angular, other: Outline.Round): Boolean = one.contains(other.centre) ||
    edges(one.corners).any { (from, to) -> distance(other.centre, from, to) < other.radius }

private fun overlap(one: Outline.Angular, other: Outline.Angular): Boolean =
    one.contains(other.corners.first()) || other.contains(one.corners.first()) ||
        edges(one.corners).any { (from, to) ->
            edges(other.corners).any { (otherFrom, otherTo) -> cross(from, to, otherFrom, otherTo) }
        }

private fun Outline.contains(point: Point) = contains(point.x, point.y)

private fun edges(corners: List<Point>): List<Pair<Point, Point>> = corners.indices.map {
    corners[it] to
        corners[(it + 1) % corners.size]
}

private fun within(one: Point, other: Point, reach: Double): Boolean = distance(one, other, other) < reach

private fun foldsBack(from: Point, corner: Point, to: Point): Boolean = side(from, corner, to) == 0.0 &&
    (corner.x - from.x) * (to.x - corner.x) + (corner.y - from.y) * (to.y - corner.y) < 0

/** Whether two line segments have a common point. */
private fun meet(from: Point, to: Point, otherFrom: Point, otherTo: Point): Boolean =
    cross(from, to, otherFrom, otherTo) || isOn(from, to, otherFrom) || isOn(from, to, otherTo) ||
        isOn(otherFrom, otherTo, from) || isOn(otherFrom, otherTo, to)

private fun isOn(from: Point, to: Point, point: Point): Boolean =
    side(from, to, point) == 0.0 && point.x in minOf(from.x, to.x)..maxOf(from.x, to.x) &&
        point.y in minOf(from.y, to.y)..maxOf(from.y, to.y)
