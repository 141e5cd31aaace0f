package robotran.simulation.light

import robotran.world.Penbot
import robotran.world.geometry.Point
import robotran.world.geometry.distance
import kotlin.math.floor

/**
 * The ink on the paper as the light sensor sees it: a raster in which a pen's line is six cells wide, stored in tiles
 * that exist only where there is ink.
 */
internal class InkRaster {
    private val tiles = HashMap<Long, LongArray>()
    private val latestKeys = LongArray(LATEST_TILES) { Long.MIN_VALUE }
    private val latestTiles = arrayOfNulls<LongArray>(LATEST_TILES)

    /** Changes whenever ink reaches a cell that had none. */
    var version = 0
        private set

    /** Draws a straight segment. */
    fun draw(from: Point, to: Point) {
        val left = cellOf(minOf(from.x, to.x) - RADIUS)
        val right = cellOf(maxOf(from.x, to.x) + RADIUS)
        val bottom = cellOf(minOf(from.y, to.y) - RADIUS)
        val top = cellOf(maxOf(from.y, to.y) + RADIUS)
        for (row in bottom..top) {
            for (column in left..right) {
                if (distance(Point(middleOf(column), middleOf(row)), from, to) <= RADIUS) blacken(column, row)
            }
        }
    }

    /** Whether there is ink anywhere near a rectangle; may be true without ink inside. */
    fun mayHave(left: Double, bottom: Double, right: Double, top: Double): Boolean {
        if (tiles.isEmpty()) return false
        for (row in (cellOf(bottom) shr TILE_SHIFT)..(cellOf(top) shr TILE_SHIFT)) {
            for (column in (cellOf(left) shr TILE_SHIFT)..(cellOf(right) shr TILE_SHIFT)) {
                if (tileAt(column, row) != null) return true
            }
        }
        return false
    }

    /** Whether there is ink at a point. */
    fun has(x: Double, y: Double): Boolean {
        val column = cellOf(x)
        val row = cellOf(y)
        val tile = tileAt(column shr TILE_SHIFT, row shr TILE_SHIFT) ?: return false
        return tile[row and TILE_MASK] ushr (column and TILE_MASK) and 1L == 1L
    }

    private fun blacken(column: Int, row: Int) {
        val tile = tileAt(column shr TILE_SHIFT, row shr TILE_SHIFT)
            ?: newTileAt(column shr TILE_SHIFT, row shr TILE_SHIFT)
        val before = tile[row and TILE_MASK]
        val after = before or (1L shl (column and TILE_MASK))
        if (after != before) {
            tile[row and TILE_MASK] = after
            version++
        }
    }

    /** The tile in a column and a row of tiles, if there is ink. Most calls are for a tile of the calls before. */
    private fun tileAt(column: Int, row: Int): LongArray? {
        val key = key(column, row)
        val place = placeOf(column, row)
        if (latestKeys[place] == key) return latestTiles[place]
        return tiles[key].also { keep(place, key, it) }
    }

    private fun newTileAt(column: Int, row: Int): LongArray {
        val key = key(column, row)
        return LongArray(TILE_CELLS).also {
            tiles[key] = it
            keep(placeOf(column, row), key, it)
        }
    }

    private fun keep(place: Int, key: Long, tile: LongArray?) {
        latestKeys[place] = key
        latestTiles[place] = tile
    }

    private fun placeOf(column: Int, row: Int): Int = (row and LATEST_MASK) * LATEST_SIDE + (column and LATEST_MASK)

    private fun key(column: Int, row: Int): Long = row.toLong() * ROW + column

    private fun cellOf(place: Double): Int = floor(place * CELLS_PER_CENTIMETRE).toInt()

    private fun middleOf(cell: Int): Double = (cell + HALF) / CELLS_PER_CENTIMETRE

    private companion object {
        const val CELLS_PER_CENTIMETRE = 20.0
        const val RADIUS = Penbot.PEN_LINE_WIDTH / 2
        const val TILE_SHIFT = 6
        const val TILE_CELLS = 64
        const val TILE_MASK = 63
        const val HALF = 0.5

        /** A square of tiles, of which [tileAt] finds the latest without the map. */
        const val LATEST_SIDE = 8
        const val LATEST_MASK = LATEST_SIDE - 1
        const val LATEST_TILES = LATEST_SIDE * LATEST_SIDE

        /** More tiles than any paper is wide; a prime, so that tiles side by side have different hash codes. */
        const val ROW = 1_000_003L
    }
}
