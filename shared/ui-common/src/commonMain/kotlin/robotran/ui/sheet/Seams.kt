package robotran.ui.sheet

import robotran.uikit.*
import robotran.world.geometry.Point
import robotran.world.geometry.Shape

/**
 * A region as drawn. A polygon with a hole, such as the paper around a ring, is cut open by a narrow slit in its file.
 * Here both sides of the slit lie on one line, and its edges are known.
 *
 * @property seams the indices of the slit's edges; an edge goes from the corner with its index to the next.
 */
internal class SeamlessPolygon(val corners: List<Point>, val seams: Set<Int>) {
    /** Its outline in pieces, without the seams; null if it has none. */
    val outline: List<List<Point>>? = if (seams.isEmpty()) null else pieces()

    /** Starts at a seam, so that no piece is split. */
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

        /** Whether two edges are close and parallel over their whole length. */
        private fun isSlit(corners: List<Point>, one: Int, other: Int): Boolean {
            val next = (one + 1) % corners.size
            val after = (other + 1) % corners.size
            if (one == other || next == other || after == one) return false
            return distance(corners[one], corners[next]) > SLIT && distance(corners[one], corners[after]) < SLIT &&
                distance(corners[next], corners[other]) < SLIT
        }

        /** The point halfway to the corner on the other side. */
        private fun closed(corner: Point, number: Int, corners: List<Point>, lips: Set<Int>): Point {
            val other = lips.filter {
                it != number && distance(corners[it], corner) < SLIT
            }.minByOrNull { distance(corners[it], corner) }
            return other?.let { Point((corner.x + corners[it].x) / 2, (corner.y + corners[it].y) / 2) } ?: corner
        }

        /** The max width in centimetres. */
        private const val SLIT = 0.4
    }
}
