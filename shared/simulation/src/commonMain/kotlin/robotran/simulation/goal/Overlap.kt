package robotran.simulation.goal

import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.cross
import robotran.world.geometry.length

/** The distance of a point from the outline's area, 0 inside. */
internal fun Outline.distanceTo(point: Point): Double =
    if (contains(point.x, point.y)) 0.0 else distanceToEdge(point.x, point.y)

/** Whether all of this is in [region], including the edges. */
internal fun Outline.isInside(region: Outline): Boolean = when (this) {
    is Outline.Round -> region.contains(centre.x, centre.y) &&
        region.distanceToEdge(centre.x, centre.y) >= radius - TOLERANCE

    is Outline.Angular -> corners.all { region.distanceTo(it) <= TOLERANCE } &&
        (region is Outline.Round || !crosses(region as Outline.Angular))
}

/** Whether any part of this is in [region]. */
internal fun Outline.meets(region: Outline): Boolean = when {
    bounds.right < region.bounds.left || bounds.left > region.bounds.right -> false
    bounds.top < region.bounds.bottom || bounds.bottom > region.bounds.top -> false

    this is Outline.Round && region is Outline.Round -> length(
        centre.x - region.centre.x,
        centre.y - region.centre.y,
    ) <= radius + region.radius

    this is Outline.Round -> region.distanceTo(centre) <= radius
    region is Outline.Round -> distanceTo(region.centre) <= region.radius
    else -> (this as Outline.Angular).meetsAngular(region as Outline.Angular)
}

private fun Outline.Angular.meetsAngular(region: Outline.Angular): Boolean =
    corners.any { region.contains(it.x, it.y) } || region.corners.any { contains(it.x, it.y) } || crosses(region)

/** Whether an edge of one crosses an edge of the other. */
private fun Outline.Angular.crosses(other: Outline.Angular): Boolean = corners.indices.any { number ->
    val from = corners[number]
    val to = corners[(number + 1) % corners.size]
    other.corners.indices.any { cross(from, to, other.corners[it], other.corners[(it + 1) % other.corners.size]) }
}

/** A tenth of a millimetre, in centimetres: too small to see. */
private const val TOLERANCE = 0.01
