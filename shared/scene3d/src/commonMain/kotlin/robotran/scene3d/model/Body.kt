package robotran.scene3d.model

import robotran.scene3d.geometry.ConvexPolygon

/**
 * A convex solid in its own coordinates, all of whose [faces] are seen from outside only.
 *
 * @property faces all of its sides, also those of [bands].
 * @property footprint what it covers, seen from above.
 */
class Body(
    val footprint: ConvexPolygon,
    val bottom: Double,
    val top: Double,
    val faces: List<Face>,
    val bands: List<Band> = emptyList(),
)

/**
 * A round side: flat [faces] side by side, in one closed ring. Those that are seen are drawn as one polygon whose
 * shade changes from face to face.
 *
 * @property faces each with its corners in the order lower, lower next, upper next, upper.
 */
class Band(val faces: List<Face>)

/** The edge of a level of a body: a polygon at a height. */
internal class Ring(val polygon: ConvexPolygon, val height: Double)

/**
 * A convex body between [rings] with the same number of corners, from bottom to top.
 *
 * @param colours of the sides above each ring.
 * @param hidden for each edge, whether its sides are never seen; null for none.
 * @param sideDecals what is on the sides above the ring and beyond the edge with these indices.
 */
internal fun loft(
    rings: List<Ring>,
    colours: List<Int>,
    topColour: Int,
    smooth: Boolean = false,
    hidden: BooleanArray? = null,
    topDecals: List<Decal> = emptyList(),
    glows: Boolean = false,
    sideDecals: (Int, Int) -> List<Decal> = { _, _ -> emptyList() },
): Body {
    val faces = mutableListOf<Face>()
    val bands = mutableListOf<Band>()
    val count = rings.first().polygon.size
    for (level in 0 until rings.size - 1) {
        val before = faces.size
        val low = rings[level]
        val high = rings[level + 1]
        for (edge in 0 until count) {
            val next = (edge + 1) % count
            val corners = low.corner(edge) + low.corner(next) + high.corner(next) + high.corner(edge)
            faces += Face(corners, colours[level], sideDecals(level, edge), smooth, glows, hidden?.get(edge) == true)
        }
        if (smooth) bands += Band(faces.subList(before, faces.size).toList())
    }
    val top = rings.last()
    // A top that goes on in another piece must not show where they meet.
    val isJoined = hidden?.any { it } == true
    faces += Face(corners(top, (0 until count).toList()), topColour, topDecals, isJoined, glows)
    val bottom = rings.first()
    faces += Face(corners(bottom, (count - 1 downTo 0).toList()), colours.first(), glows = glows)
    val outline = ConvexPolygon.around(rings.flatMap { it.polygon.corners }) ?: top.polygon
    return Body(outline, bottom.height, top.height, faces, bands)
}

/** An upright prism over [polygon]. */
internal fun prism(
    polygon: ConvexPolygon,
    bottom: Double,
    top: Double,
    colour: Int,
    topColour: Int = colour,
    smooth: Boolean = false,
    hidden: BooleanArray? = null,
    topDecals: List<Decal> = emptyList(),
    glows: Boolean = false,
    sideDecals: (Int, Int) -> List<Decal> = { _, _ -> emptyList() },
): Body = loft(
    listOf(Ring(polygon, bottom), Ring(polygon, top)),
    listOf(colour),
    topColour,
    smooth,
    hidden,
    topDecals,
    glows,
    sideDecals,
)

private fun Ring.corner(number: Int) = doubleArrayOf(polygon.x(number), polygon.y(number), height)

private fun corners(ring: Ring, order: List<Int>): DoubleArray = DoubleArray(order.size * 3) {
    val corner = order[it / 3]
    when (it % 3) {
        0 -> ring.polygon.x(corner)
        1 -> ring.polygon.y(corner)
        else -> ring.height
    }
}
