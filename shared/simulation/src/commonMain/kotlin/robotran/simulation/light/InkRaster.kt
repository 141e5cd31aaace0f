package robotran.simulation.light

import robotran.world.Penbot
import robotran.world.geometry.Point
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
        val line = Capsule(from, to, SQUARED_RADIUS)
        for (tileRow in (bottom shr TILE_SHIFT)..(top shr TILE_SHIFT)) {
            for (tileColumn in (left shr TILE_SHIFT)..(right shr TILE_SHIFT)) {
                val firstRow = tileRow shl TILE_SHIFT
                val firstColumn = tileColumn shl TILE_SHIFT
                val begin = maxOf(left - firstColumn, 0)
                val columns = (-1L shl begin) and (-1L ushr (TILE_MASK - minOf(right - firstColumn, TILE_MASK)))
                for (row in maxOf(bottom, firstRow)..minOf(top, firstRow + TILE_MASK)) {
                    draw(line, tileColumn, tileRow, row, columns)
                }
            }
        }
    }

    /** Blackens the cells of [row] in a tile that [line] covers, of those whose bits are set in [columns]. */
    private fun draw(line: Capsule, tileColumn: Int, tileRow: Int, row: Int, columns: Long) {
        val known = tileAt(tileColumn, tileRow)
        // Most of a line lies on what has just been drawn.
        var white = if (known == null) columns else columns and known[row and TILE_MASK].inv()
        var black = 0L
        val y = middleOf(row)
        while (white != 0L) {
            val place = white.countTrailingZeroBits()
            white = white and (white - 1)
            if (line.contains(middleOf((tileColumn shl TILE_SHIFT) + place), y)) black = black or (1L shl place)
        }
        if (black == 0L) return
        val tile = known ?: newTileAt(tileColumn, tileRow)
        tile[row and TILE_MASK] = tile[row and TILE_MASK] or black
        version++
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
        val SQUARED_RADIUS = squareLimit(RADIUS)
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
