package robotran.simulation.goal

import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.cross
import robotran.world.geometry.length

/**
 * How far a point or a thing is outside a region.
 *
 * @property place the part of it that is furthest outside.
 * @property target the point of the region that is nearest to [place].
 * @property centimetres between the two, 0 if nothing is outside.
 */
internal class Overhang(val place: Point, val target: Point, val centimetres: Double)

/** How far this point is outside [region]. */
internal fun Point.overhang(region: Outline): Overhang = region.nearestPoint(this).let {
    Overhang(this, it, length(x - it.x, y - it.y))
}

/** How far this is outside [region]. */
internal fun Outline.overhang(region: Outline): Overhang = when (this) {
    is Outline.Angular -> corners.map { it.overhang(region) }.maxBy { it.centimetres }
    is Outline.Round -> overhang(region)
}

private fun Outline.Round.overhang(region: Outline): Overhang {
    val isInside = region.contains(centre.x, centre.y)
    val edge = region.nearestEdgePoint(centre)
    val away = length(edge.x - centre.x, edge.y - centre.y)
    val centimetres = maxOf(0.0, if (isInside) radius - away else radius + away)
    if (away == 0.0) return Overhang(centre, edge, centimetres)
    val outwards = (if (isInside) radius else -radius) / away
    val place = Point(centre.x + outwards * (edge.x - centre.x), centre.y + outwards * (edge.y - centre.y))
    return Overhang(place, edge, centimetres)
}

/** The point of this area nearest to [point]. */
internal fun Outline.nearestPoint(point: Point): Point =
    if (contains(point.x, point.y)) point else nearestEdgePoint(point)

/** The point of the edge nearest to [point]. */
internal fun Outline.nearestEdgePoint(point: Point): Point = when (this) {
    is Outline.Round -> {
        val away = length(point.x - centre.x, point.y - centre.y)
        if (away == 0.0) {
            Point(centre.x + radius, centre.y)
        } else {
            Point(centre.x + (point.x - centre.x) * radius / away, centre.y + (point.y - centre.y) * radius / away)
        }
    }

    is Outline.Angular -> {
        corners.indices.map { nearestOf(point, corners[it], corners[(it + 1) % corners.size]) }
            .minBy { length(point.x - it.x, point.y - it.y) }
    }
}

/** A point that is both in this and in [region], or almost, if they meet. */
internal fun Outline.commonPoint(region: Outline): Point = when {
    this is Outline.Round -> region.nearestPoint(centre)
    region is Outline.Round -> nearestPoint(region.centre)
    else -> (this as Outline.Angular).commonPointAngular(region as Outline.Angular)
}

private fun Outline.Angular.commonPointAngular(region: Outline.Angular): Point =
    corners.find { region.contains(it.x, it.y) }
        ?: region.corners.find { contains(it.x, it.y) }
        ?: nearestContact(region).first

/**
 * The point of [other] nearest to this, and the distance between them, 0 if they meet.
 */
internal fun Outline.Angular.nearestContact(other: Outline): Pair<Point, Double> {
    crossing(other)?.let { return it to 0.0 }
    val fromHere = corners.map { it to other.nearestPoint(it) }
    val fromThere = when (other) {
        is Outline.Round -> listOf(nearestPoint(other.centre).let { it to other.nearestPoint(it) })
        is Outline.Angular -> other.corners.map { nearestPoint(it) to it }
    }
    return (fromHere + fromThere).map { (here, there) -> there to length(here.x - there.x, here.y - there.y) }
        .minBy { it.second }
}

/** A point where the edges of both cross; null if they do not, or if [other] is round. */
private fun Outline.Angular.crossing(other: Outline): Point? {
    if (other !is Outline.Angular) return null
    for (number in corners.indices) {
        val from = corners[number]
        val to = corners[(number + 1) % corners.size]
        for (next in other.corners.indices) {
            val otherFrom = other.corners[next]
            val otherTo = other.corners[(next + 1) % other.corners.size]
            if (cross(from, to, otherFrom, otherTo)) return crossingOf(from, to, otherFrom, otherTo)
        }
    }
    return null
}

private fun crossingOf(from: Point, to: Point, otherFrom: Point, otherTo: Point): Point {
    val alongX = to.x - from.x
    val alongY = to.y - from.y
    val otherX = otherTo.x - otherFrom.x
    val otherY = otherTo.y - otherFrom.y
    val share = ((otherFrom.x - from.x) * otherY - (otherFrom.y - from.y) * otherX) /
        (alongX * otherY - alongY * otherX)
    return Point(from.x + share * alongX, from.y + share * alongY)
}

/** The point between [from] and [to] nearest to [point]. */
private fun nearestOf(point: Point, from: Point, to: Point): Point {
    val alongX = to.x - from.x
    val alongY = to.y - from.y
    val squared = alongX * alongX + alongY * alongY
    if (squared == 0.0) return from
    val share = (((point.x - from.x) * alongX + (point.y - from.y) * alongY) / squared).coerceIn(0.0, 1.0)
    return Point(from.x + share * alongX, from.y + share * alongY)
}
