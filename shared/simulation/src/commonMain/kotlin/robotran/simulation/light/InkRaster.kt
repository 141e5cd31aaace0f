package robotran.simulation.light

import robotran.world.Paper
import robotran.world.Penbot
import robotran.world.geometry.Point
import kotlin.math.floor

/**
 * The ink on the paper as the light sensor sees it: a raster in which a pen's line is six cells wide, stored in tiles
 * that exist only where there is ink.
 */
internal class InkRaster(paper: Paper) {
    private val tiles = InkTiles(tileOf(cellOf(paper.width)), tileOf(cellOf(paper.height)))

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
        for (tileRow in tileOf(bottom)..tileOf(top)) {
            for (tileColumn in tileOf(left)..tileOf(right)) {
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
        val known = tiles[tileColumn, tileRow]
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
        val tile = known ?: tiles.add(tileColumn, tileRow)
        tile[row and TILE_MASK] = tile[row and TILE_MASK] or black
        version++
    }

    /** Whether there is ink anywhere near a rectangle; may be true without ink inside. */
    fun mayHave(left: Double, bottom: Double, right: Double, top: Double): Boolean {
        if (tiles.isEmpty) return false
        for (row in tileOf(cellOf(bottom))..tileOf(cellOf(top))) {
            for (column in tileOf(cellOf(left))..tileOf(cellOf(right))) {
                if (tiles[column, row] != null) return true
            }
        }
        return false
    }

    /** Whether there is ink at a point. */
    fun has(x: Double, y: Double): Boolean {
        val column = cellOf(x)
        val row = cellOf(y)
        val tile = tiles[tileOf(column), tileOf(row)] ?: return false
        return tile[row and TILE_MASK] ushr (column and TILE_MASK) and 1L == 1L
    }

    private fun cellOf(place: Double): Int = floor(place * CELLS_PER_CENTIMETRE).toInt()

    private fun tileOf(cell: Int): Int = cell shr TILE_SHIFT

    private fun middleOf(cell: Int): Double = (cell + HALF) / CELLS_PER_CENTIMETRE

    private companion object {
        const val CELLS_PER_CENTIMETRE = 20.0
        const val RADIUS = Penbot.PEN_LINE_WIDTH / 2
        val SQUARED_RADIUS = squareLimit(RADIUS)
        const val TILE_SHIFT = 6
        const val TILE_MASK = 63
        const val HALF = 0.5
    }
}
