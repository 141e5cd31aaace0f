package robotran.world.geometry

import kotlin.math.PI

/** A [Shape] prepared for geometric queries, with its rotation and all angles computed. */
sealed class Outline {
    /** The axis-aligned bounding box. */
    abstract val bounds: Bounds

    /** Whether a point is inside, including the edge. */
    abstract fun contains(x: Double, y: Double): Boolean

    /** Distance of a point from the edge, from inside or outside. */
    abstract fun distanceToEdge(x: Double, y: Double): Double

    class Round(val centre: Point, val radius: Double) : Outline() {
        override val bounds = Bounds(centre.x - radius, centre.y - radius, centre.x + radius, centre.y + radius)

        override fun contains(x: Double, y: Double): Boolean {
            val toX = x - centre.x
            val toY = y - centre.y
            return toX * toX + toY * toY <= radius * radius
        }

        override fun distanceToEdge(x: Double, y: Double): Double =
            kotlin.math.abs(length(x - centre.x, y - centre.y) - radius)
    }

    /** @property corners counter-clockwise. */
    class Angular(val corners: List<Point>) : Outline() {
        override val bounds =
            Bounds(corners.minOf { it.x }, corners.minOf { it.y }, corners.maxOf { it.x }, corners.maxOf { it.y })

        override fun contains(x: Double, y: Double): Boolean {
            if (!bounds.contains(x, y)) return false
            var inside = false
            var before = corners.last()
            for (corner in corners) {
                if ((corner.y > y) != (before.y > y) &&
                    x < (before.x - corner.x) * (y - corner.y) / (before.y - corner.y) + corner.x
                ) {
                    inside = !inside
                }
                before = corner
            }
            return inside
        }

        override fun distanceToEdge(x: Double, y: Double): Double {
            val place = Point(x, y)
            return corners.indices.minOf { distance(place, corners[it], corners[(it + 1) % corners.size]) }
        }
    }
}

/** An axis-aligned rectangle, including its edges. */
data class Bounds(val left: Double, val bottom: Double, val right: Double, val top: Double) {
    fun contains(x: Double, y: Double): Boolean = x in left..right && y in bottom..top

    fun grownBy(margin: Double) = Bounds(left - margin, bottom - margin, right + margin, top + margin)
}

/** The outline of the shape on the sheet, in centimetres; the corners of a polygon are counter-clockwise. */
fun Shape.outline(trigonometry: Trigonometry): Outline = when (this) {
    is Shape.Circle -> Outline.Round(centre, radius)
    is Shape.Polygon -> Outline.Angular(if (signedArea(corners) < 0) corners.reversed() else corners)
    is Shape.Rectangle -> Outline.Angular(corners(trigonometry))
}

/** Counter-clockwise, from the one that is the lower left corner before the rotation. */
private fun Shape.Rectangle.corners(trigonometry: Trigonometry): List<Point> {
    val cosine = trigonometry.cosine(angle * RADIANS_PER_DEGREE)
    val sine = trigonometry.sine(angle * RADIANS_PER_DEGREE)

    fun corner(x: Double, y: Double) = Point(centre.x + x * cosine - y * sine, centre.y + x * sine + y * cosine)
    return listOf(
        corner(-width / 2, -height / 2),
        corner(width / 2, -height / 2),
        corner(width / 2, height / 2),
        corner(-width / 2, height / 2),
    )
}

/** Twice the signed area within [corners]: positive if they are counter-clockwise. */
fun signedArea(corners: List<Point>): Double = corners.indices.sumOf { number ->
    val corner = corners[number]
    val next = corners[(number + 1) % corners.size]
    corner.x * next.y - next.x * corner.y
}

/** The pivot of a shape: the centre of a rectangle or circle, the centroid of a polygon. */
val Shape.centre: Point
    get() = when (this) {
        is Shape.Rectangle -> centre
        is Shape.Circle -> centre
        is Shape.Polygon -> centroid(corners)
    }

private fun centroid(corners: List<Point>): Point {
    val twiceArea = signedArea(corners)
    if (twiceArea == 0.0) return Point(corners.sumOf { it.x } / corners.size, corners.sumOf { it.y } / corners.size)
    val first = corners.first()
    var x = 0.0
    var y = 0.0
    for (number in 1..<corners.size - 1) {
        val corner = corners[number]
        val next = corners[number + 1]
        val part = (corner.x - first.x) * (next.y - first.y) - (next.x - first.x) * (corner.y - first.y)
        x += part * (corner.x - first.x + next.x - first.x)
        y += part * (corner.y - first.y + next.y - first.y)
    }
    return Point(first.x + x / (THIRDS * twiceArea), first.y + y / (THIRDS * twiceArea))
}

const val RADIANS_PER_DEGREE = PI / 180.0
private const val THIRDS = 3.0
