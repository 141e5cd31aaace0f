package robotran.ui.sheet

import robotran.world.geometry.Point
import robotran.world.geometry.Shape

/**
 * A region as it is drawn. A polygon with a hole, such as all the paper around a ring, has to be cut open somewhere,
 * and its file says so with a slit that nobody is to see: here both lips of it lie on one line, and its edges are
 * known.
 *
 * @property seams the numbers of the edges that are lips of a slit; an edge goes from the corner with its number to the
 * next.
 */
internal class SeamlessPolygon(val corners: List<Point>, val seams: Set<Int>) {
    /** Its edge in pieces, without the seams; null if it has none. */
    val outline: List<List<Point>>? = if (seams.isEmpty()) null else pieces()

    /** From a seam on, so that no piece is begun in its middle. */
    private fun pieces(): List<List<Point>> = buildList {
        var piece = mutableListOf<Point>()
        for (edge in corners.indices.map { (seams.first() + it) % corners.size }) {
            if (edge in seams) {
                piece = mutableListOf()
            } else {
                if (piece.isEmpty()) {
                    piece += corners[edge]
                    add(piece)
                }
                piece += corners[(edge + 1) % corners.size]
            }
        }
    }

    companion object {
        fun of(shape: Shape.Polygon): SeamlessPolygon {
            val corners = shape.corners
            val seams = corners.indices.filter { one -> corners.indices.any { isSlit(corners, one, it) } }.toSet()
            if (seams.isEmpty()) return SeamlessPolygon(corners, seams)
            val lips = seams.flatMap { listOf(it, (it + 1) % corners.size) }.toSet()
            val moved = corners.mapIndexed { number, corner ->
                if (number in
                    lips
                ) {
                    closed(corner, number, corners, lips)
                } else {
                    corner
                }
            }
            return SeamlessPolygon(moved, seams)
        }

        /** Whether two edges lie close beside each other over all of their length. */
        private fun isSlit(corners: List<Point>, one: Int, other: Int): Boolean {
            val next = (one + 1) % corners.size
            val after = (other + 1) % corners.size
            if (one == other || next == other || after == one) return false
            return distance(corners[one], corners[next]) > SLIT && distance(corners[one], corners[after]) < SLIT &&
                distance(corners[next], corners[other]) < SLIT
        }

        /** Halfway to the corner on the other lip. */
        private fun closed(corner: Point, number: Int, corners: List<Point>, lips: Set<Int>): Point {
            val other = lips.filter {
                it != number && distance(corners[it], corner) < SLIT
            }.minByOrNull { distance(corners[it], corner) }
            return other?.let { Point((corner.x + corners[it].x) / 2, (corner.y + corners[it].y) / 2) } ?: corner
        }

        /** No wider than this, in centimetres. */
        private const val SLIT = 0.4
    }
}
