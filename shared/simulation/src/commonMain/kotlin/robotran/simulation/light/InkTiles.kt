package robotran.simulation.light

/**
 * The tiles of an [InkRaster], 64 words each, by column and row. Lines reach at most one tile beyond the paper, whose
 * first tile is number 0 and whose last ones are [lastColumn] and [lastRow].
 */
internal class InkTiles(private val lastColumn: Int, lastRow: Int) {
    private val rows = arrayOfNulls<Array<LongArray?>>(lastRow + 1 + 2 * BEYOND)

    var isEmpty = true
        private set

    /** The tile, if there is ink in it. */
    operator fun get(column: Int, row: Int): LongArray? = rows.getOrNull(row + BEYOND)?.getOrNull(column + BEYOND)

    /** Adds a tile that does not exist yet. */
    fun add(column: Int, row: Int): LongArray {
        val tiles = rows[row + BEYOND]
            ?: arrayOfNulls<LongArray>(lastColumn + 1 + 2 * BEYOND).also { rows[row + BEYOND] = it }
        isEmpty = false
        return LongArray(WORDS).also { tiles[column + BEYOND] = it }
    }

    private companion object {
        const val BEYOND = 1
        const val WORDS = 64
    }
}
