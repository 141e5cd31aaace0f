package robotran.scene3d.geometry

import robotran.world.geometry.Point
import robotran.world.geometry.signedArea

/**
 * A convex part of a shape.
 *
 * @property outer for each edge, from the corner with its index to the next, whether it is an edge of the whole shape;
 * the others lie inside of it and are never seen.
 */
class ConvexPiece(val polygon: ConvexPolygon, val outer: BooleanArray)

/** Cuts the polygon with these [corners] into convex pieces: ears first, which are then joined as far as possible. */
fun convexPieces(corners: List<Point>): List<ConvexPiece> {
    val ring = if (signedArea(corners) < 0) corners.reversed() else corners
    val pieces = ears(ring).toMutableList()
    joinPieces(pieces, ring)
    return pieces.map { piece ->
        ConvexPiece(
            ConvexPolygon(piece.map { ring[it] }),
            BooleanArray(piece.size) { (piece[it] + 1) % ring.size == piece[(it + 1) % piece.size] },
        )
    }
}

/** Triangles of corner indices. */
private fun ears(ring: List<Point>): List<List<Int>> {
    val left = ring.indices.toMutableList()
    val triangles = mutableListOf<List<Int>>()
    while (left.size > ConvexPolygon.MIN_CORNERS) {
        val ear = left.indices.firstOrNull { isEar(ring, left, it) } ?: left.indices.maxBy { area(ring, left, it) }
        triangles += triangle(left, ear)
        left.removeAt(ear)
    }
    triangles += left.toList()
    return triangles.filter { (one, two, three) -> turn(ring[one], ring[two], ring[three]) > FLAT }
}

private fun triangle(left: List<Int>, ear: Int): List<Int> =
    listOf(left[(ear + left.size - 1) % left.size], left[ear], left[(ear + 1) % left.size])

private fun area(ring: List<Point>, left: List<Int>, ear: Int): Double =
    triangle(left, ear).let { (one, two, three) -> turn(ring[one], ring[two], ring[three]) }

private fun isEar(ring: List<Point>, left: List<Int>, ear: Int): Boolean {
    val (one, two, three) = triangle(left, ear)
    if (turn(ring[one], ring[two], ring[three]) <= FLAT) return false
    return left.none { it != one && it != two && it != three && isIn(ring, one, two, three, ring[it]) }
}

private fun isIn(ring: List<Point>, one: Int, two: Int, three: Int, point: Point): Boolean =
    turn(ring[one], ring[two], point) >= 0 && turn(ring[two], ring[three], point) >= 0 &&
        turn(ring[three], ring[one], point) >= 0

private fun joinPieces(pieces: MutableList<List<Int>>, ring: List<Point>) {
    var one = 0
    while (one < pieces.size) {
        val other = (one + 1 until pieces.size).firstOrNull { joined(pieces[one], pieces[it], ring) != null }
        if (other == null) {
            one++
        } else {
            pieces[one] = checkNotNull(joined(pieces[one], pieces[other], ring))
            pieces.removeAt(other)
        }
    }
}

/** Both as one piece, if they share an edge and it is convex. */
private fun joined(one: List<Int>, other: List<Int>, ring: List<Point>): List<Int>? {
    for (edge in one.indices) {
        val from = one[edge]
        val to = one[(edge + 1) % one.size]
        val there = other.indexOf(to)
        if (there < 0 || other[(there + 1) % other.size] != from) continue
        val rest = List(other.size - 2) { other[(there + 2 + it) % other.size] }
        val both = List(edge + 1) { one[it] } + rest + one.drop(edge + 1)
        val isConvex = both.indices.all {
            turn(ring[both[it]], ring[both[(it + 1) % both.size]], ring[both[(it + 2) % both.size]]) >= 0
        }
        return both.takeIf { isConvex }
    }
    return null
}

/**
 * The parts of this piece outside of [other]. Edges along [other] count as inner ones, because it hides what is
 * behind them.
 */
fun ConvexPiece.without(other: ConvexPolygon): List<ConvexPiece> {
    if (!polygon.overlaps(other)) return listOf(this)
    val parts = mutableListOf<ConvexPiece>()
    var rest: ConvexPiece = this
    for (edge in 0 until other.size) {
        val next = (edge + 1) % other.size
        // Pointing out of the other polygon.
        val normalX = other.y(next) - other.y(edge)
        val normalY = other.x(edge) - other.x(next)
        val offset = normalX * other.x(edge) + normalY * other.y(edge)
        rest.cut(normalX, normalY, offset)?.let { parts += it }
        rest = rest.cut(-normalX, -normalY, -offset) ?: break
    }
    return parts
}

/** The part beyond a line; the edge along the line is an inner one. */
private fun ConvexPiece.cut(normalX: Double, normalY: Double, offset: Double): ConvexPiece? {
    val scale = kotlin.math.sqrt(normalX * normalX + normalY * normalY)
    val sides = DoubleArray(polygon.size) {
        (normalX * polygon.x(it) + normalY * polygon.y(it) - offset) / scale
    }
    if (sides.all { it >= -THIN }) return this
    if (sides.all { it <= THIN }) return null
    val corners = mutableListOf<Point>()
    val edges = mutableListOf<Boolean>()
    for (corner in 0 until polygon.size) {
        val next = (corner + 1) % polygon.size
        val here = Point(polygon.x(corner), polygon.y(corner))
        if (sides[corner] >= 0) {
            corners += here
            edges += if (sides[next] < 0 && sides[corner] == 0.0) false else outer[corner]
        }
        if ((sides[corner] > 0 && sides[next] < 0) || (sides[corner] < 0 && sides[next] > 0)) {
            val share = sides[corner] / (sides[corner] - sides[next])
            corners += Point(
                here.x + share * (polygon.x(next) - here.x),
                here.y + share * (polygon.y(next) - here.y),
            )
            edges += if (sides[corner] > 0) false else outer[corner]
        }
    }
    if (corners.size < ConvexPolygon.MIN_CORNERS) return null
    return ConvexPiece(ConvexPolygon(corners), edges.toBooleanArray())
}

/** Whether the insides of both have points in common. */
private fun ConvexPolygon.overlaps(other: ConvexPolygon): Boolean = !isBeside(other) && !other.isBeside(this)

/** Whether one of this polygon's edges has all of [other] on its outer side. */
private fun ConvexPolygon.isBeside(other: ConvexPolygon): Boolean = (0 until size).any { edge ->
    val next = (edge + 1) % size
    val normalX = y(next) - y(edge)
    val normalY = x(edge) - x(next)
    val scale = kotlin.math.sqrt(normalX * normalX + normalY * normalY)
    (0 until other.size).all {
        normalX * (other.x(it) - x(edge)) + normalY * (other.y(it) - y(edge)) >= -THIN * scale
    }
}

/** In square centimetres: less is no area. */
private const val FLAT = 1e-9

/** In centimetres: what overlaps by less than this only touches. */
private const val THIN = 1e-6
