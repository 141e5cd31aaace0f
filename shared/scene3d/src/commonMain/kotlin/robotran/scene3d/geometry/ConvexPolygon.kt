package robotran.scene3d.geometry

import robotran.world.geometry.Point

/**
 * A convex polygon on the paper.
 *
 * @property xy its corners, counter-clockwise: x and y in turn, in centimetres. Must not be changed.
 */
class ConvexPolygon(val xy: DoubleArray) {
    constructor(corners: List<Point>) :
        this(DoubleArray(corners.size * 2) { if (it % 2 == 0) corners[it / 2].x else corners[it / 2].y })

    /** The number of corners. */
    val size: Int get() = xy.size / 2

    fun x(corner: Int): Double = xy[2 * corner]

    fun y(corner: Int): Double = xy[2 * corner + 1]

    val corners: List<Point> get() = List(size) { Point(x(it), y(it)) }

    /** Turned by the angle with this [cosine] and [sine] about the origin, then moved by [x] and [y]. */
    fun placed(x: Double, y: Double, cosine: Double, sine: Double) = ConvexPolygon(
        DoubleArray(xy.size) {
            val cornerX = xy[it - it % 2]
            val cornerY = xy[it - it % 2 + 1]
            if (it % 2 == 0) x + cornerX * cosine - cornerY * sine else y + cornerX * sine + cornerY * cosine
        },
    )

    /**
     * The part where [normalX] x + [normalY] y is at least [offset]; null if nothing is left. Its corners stay
     * counter-clockwise.
     */
    fun beyond(normalX: Double, normalY: Double, offset: Double): ConvexPolygon? {
        val sides = DoubleArray(size) { normalX * x(it) + normalY * y(it) - offset }
        if (sides.all { it >= 0 }) return this
        if (sides.all { it <= 0 }) return null
        val kept = ArrayList<Point>(size + 1)
        for (corner in 0 until size) {
            val next = (corner + 1) % size
            if (sides[corner] >= 0) kept += Point(x(corner), y(corner))
            if ((sides[corner] > 0 && sides[next] < 0) || (sides[corner] < 0 && sides[next] > 0)) {
                val share = sides[corner] / (sides[corner] - sides[next])
                kept += Point(
                    x(corner) + share * (x(next) - x(corner)),
                    y(corner) + share * (y(next) - y(corner)),
                )
            }
        }
        return if (kept.size < MIN_CORNERS) null else ConvexPolygon(kept)
    }

    companion object {
        const val MIN_CORNERS = 3

        /** The rectangle between these sides. */
        fun rectangle(left: Double, bottom: Double, right: Double, top: Double) =
            ConvexPolygon(doubleArrayOf(left, bottom, right, bottom, right, top, left, top))

        /** The smallest convex polygon around [points]; null if they have no area. */
        fun around(points: List<Point>): ConvexPolygon? {
            val sorted = points.sortedWith(compareBy({ it.x }, { it.y }))
            val hull = half(sorted) + half(sorted.asReversed())
            return if (hull.size < MIN_CORNERS) null else ConvexPolygon(hull)
        }

        /** The lower half of the hull of [sorted] points without its last one (Andrew's monotone chain). */
        private fun half(sorted: List<Point>): List<Point> {
            val chain = ArrayList<Point>()
            for (point in sorted) {
                while (chain.size >= 2 && turn(chain[chain.size - 2], chain.last(), point) <= 0) {
                    chain.removeAt(chain.size - 1)
                }
                chain += point
            }
            return chain.dropLast(1)
        }
    }
}

/** Positive for a turn to the left on the way from [from] over [by] to [to]. */
internal fun turn(from: Point, by: Point, to: Point): Double =
    (by.x - from.x) * (to.y - from.y) - (by.y - from.y) * (to.x - from.x)
