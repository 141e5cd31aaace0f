package robotran.simulation.goal

import robotran.world.MarkFigure
import robotran.world.geometry.Point
import robotran.world.geometry.length

/** A line as a path with positions from 0 to its [length]; a closed line continues with every lap, and below 0. */
internal class ArcLengthPath(line: MarkFigure.Line) {
    private val isClosed = line.closed
    private val corners = (if (isClosed) line.points + line.points.first() else line.points).withoutRepetition()

    /** The position of each corner. */
    private val places = DoubleArray(corners.size).also { places ->
        for (number in 1..<corners.size) places[number] = places[number - 1] + way(corners[number - 1], corners[number])
    }

    /** In centimetres. */
    val length: Double = places.last()

    class Nearest(val at: Double, val distance: Double)

    /**
     * The position from [from] to [to] nearest to [point]. At most one limit may be beyond the ends of an open line.
     */
    fun nearest(point: Point, from: Double, to: Double): Nearest {
        var offset = if (isClosed) kotlin.math.floor(from / length) * length else 0.0
        var number = pieceAt(from - offset)
        var nearest: Nearest? = null
        while (offset + places[number] <= to) {
            val candidate = nearestOfPiece(number, point, from - offset, to - offset)
            if (nearest == null || candidate.distance < nearest.distance) {
                nearest = Nearest(offset + candidate.at, candidate.distance)
            }
            number++
            if (number == corners.size - 1) {
                if (!isClosed) break
                number = 0
                offset += length
            }
        }
        return nearest ?: Nearest(from, Double.MAX_VALUE)
    }

    private fun nearestOfPiece(number: Int, point: Point, from: Double, to: Double): Nearest {
        val begin = corners[number]
        val end = corners[number + 1]
        val along = places[number + 1] - places[number]
        val directionX = (end.x - begin.x) / along
        val directionY = (end.y - begin.y) / along
        val foot = (point.x - begin.x) * directionX + (point.y - begin.y) * directionY
        val at = foot.coerceIn(
            0.0,
            along,
        ).coerceAtMost(to - places[number]).coerceAtLeast(minOf(from - places[number], along))
        return Nearest(
            places[number] + at,
            length(point.x - begin.x - at * directionX, point.y - begin.y - at * directionY),
        )
    }

    /** The point at the position [at], from 0 to [length]. */
    fun pointAt(at: Double): Point {
        val number = pieceAt(at)
        val share = (at - places[number]) / (places[number + 1] - places[number])
        val from = corners[number]
        val to = corners[number + 1]
        return Point(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y))
    }

    /** Index of the segment between two corners at [place]; the nearest one for a position beyond the ends. */
    private fun pieceAt(place: Double): Int {
        var low = 0
        var high = corners.size - 2
        while (low < high) {
            val middle = (low + high + 1) / 2
            if (places[middle] <= place) low = middle else high = middle - 1
        }
        return low
    }

    private companion object {
        fun way(from: Point, to: Point) = length(to.x - from.x, to.y - from.y)

        fun List<Point>.withoutRepetition() = filterIndexed { number, point ->
            number == 0 ||
                way(this[number - 1], point) > 0.0
        }
    }
}
