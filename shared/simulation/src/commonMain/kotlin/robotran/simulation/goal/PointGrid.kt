package robotran.simulation.goal

import robotran.world.geometry.Point
import kotlin.math.floor

/**
 * Points in a grid of square cells, for a fast search of those near a point.
 *
 * @param reach max radius of a search.
 */
internal class PointGrid(private val places: List<Point>, reach: Double) {
    private val left = places.minOfOrNull { it.x } ?: 0.0
    private val bottom = places.minOfOrNull { it.y } ?: 0.0
    private val cell =
        maxOf(
            reach,
            (
                places.maxOfOrNull {
                    maxOf(it.x - left, it.y - bottom)
                } ?: 0.0
            ) / MAX_CELLS_A_SIDE,
            SMALLEST_CELL,
        )
    private val columns = 1 + (places.maxOfOrNull { columnOf(it.x) } ?: 0)
    private val rows = 1 + (places.maxOfOrNull { rowOf(it.y) } ?: 0)

    /** The start of each cell's point indices in [sorted]. */
    private val begins = IntArray(columns * rows + 1)
    private val sorted = IntArray(places.size)

    val size: Int get() = places.size

    init {
        places.forEach { begins[cellOf(it) + 1]++ }
        for (number in 1..<begins.size) begins[number] += begins[number - 1]
        val next = begins.copyOf()
        places.forEachIndexed { number, place -> sorted[next[cellOf(place)]++] = number }
    }

    /** Calls [call] with the indices of all points within [distance] of a point; [distance] is at most the reach. */
    inline fun forEachWithin(x: Double, y: Double, distance: Double, call: (number: Int) -> Unit) {
        for (row in maxOf(0, rowOf(y - distance))..minOf(rows - 1, rowOf(y + distance))) {
            val from = maxOf(0, columnOf(x - distance))
            val to = minOf(columns - 1, columnOf(x + distance))
            if (from > to) return
            for (place in begins[row * columns + from]..<begins[row * columns + to + 1]) {
                val number = sorted[place]
                val awayX = places[number].x - x
                val awayY = places[number].y - y
                if (awayX * awayX + awayY * awayY <= distance * distance) call(number)
            }
        }
    }

    private fun cellOf(point: Point) = rowOf(point.y) * columns + columnOf(point.x)

    private fun columnOf(x: Double) = floor((x - left) / cell).toInt()

    private fun rowOf(y: Double) = floor((y - bottom) / cell).toInt()

    private companion object {
        const val MAX_CELLS_A_SIDE = 1000
        const val SMALLEST_CELL = 0.05
    }
}
