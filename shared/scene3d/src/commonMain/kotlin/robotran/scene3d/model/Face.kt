package robotran.scene3d.model

import robotran.scene3d.geometry.Vector3

/**
 * A flat side of a solid, in the solid's own coordinates.
 *
 * @property corners x, y and z in turn, counter-clockwise seen from outside.
 * @property decals what is painted on it or hardly sticks out of it, drawn after it and seen whenever it is.
 * @property smooth whether it is a part of a round side, whose parts must not show where they meet.
 * @property glows whether it shines itself, so that no shade falls on it.
 * @property hidden whether something else of the same height is against it, so that it is never seen.
 */
class Face(
    val corners: DoubleArray,
    val colour: Int,
    val decals: List<Decal> = emptyList(),
    val smooth: Boolean = false,
    val glows: Boolean = false,
    val hidden: Boolean = false,
) {
    /** Outwards, with the length 1. */
    val normal: Vector3

    init {
        // Newell's method: exact for flat polygons, however many corners are in a line.
        var x = 0.0
        var y = 0.0
        var z = 0.0
        val count = corners.size / AXES
        for (corner in 0 until count) {
            val here = corner * AXES
            val next = (corner + 1) % count * AXES
            x += (corners[here + 1] - corners[next + 1]) * (corners[here + 2] + corners[next + 2])
            y += (corners[here + 2] - corners[next + 2]) * (corners[here] + corners[next])
            z += (corners[here] - corners[next]) * (corners[here + 1] + corners[next + 1])
        }
        normal = Vector3(x, y, z).unit
    }

    /** The distance of its plane from the origin, along [normal]. */
    val offset: Double = normal.x * corners[0] + normal.y * corners[1] + normal.z * corners[2]

    /** The distance of [point] from its plane, outside positive. */
    fun distanceTo(point: Vector3): Double = normal.dot(point) - offset

    private companion object {
        const val AXES = 3
    }
}

/**
 * Polygons on a face, in one colour.
 *
 * @property shapes for each polygon, x, y and z of its corners in turn; they do not overlap.
 * @property fine whether they are too small to be seen from afar, and then left out.
 */
class Decal(val shapes: List<DoubleArray>, val colour: Int, val fine: Boolean = true, val glows: Boolean = false) {
    constructor(corners: DoubleArray, colour: Int, fine: Boolean = true, glows: Boolean = false) :
        this(listOf(corners), colour, fine, glows)
}
