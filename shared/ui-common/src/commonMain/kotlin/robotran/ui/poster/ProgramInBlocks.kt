package robotran.ui.poster

import robotran.blockediting.BlockProgram
import robotran.ui.code.BlockLooks
import robotran.uikit.*
import robotran.workshop.blocks.BlockRow
import robotran.workshop.blocks.rowsOf

/** A program as blocks, in up to three columns. */
internal class ProgramInBlocks(program: BlockProgram) : PosterProgram {
    private val reader = RowReader(program, BlockLooks(RobotranColours.LIGHT))
    private val rows = rowsOf(program) { false }

    /** The rows of each block that is in no other. */
    private val groups: List<List<PosterRow>> = buildList<MutableList<PosterRow>> {
        for (row in rows) {
            if (row is BlockRow.First && row.around.isEmpty()) add(mutableListOf())
            last() += reader.read(row)
        }
    }

    override fun fitted(area: PosterArea, moreLines: (Int) -> String): FittedProgram {
        LARGE_SIZES.asSequence().map { place(area, it, columns = 1) }
            .firstOrNull { it.placed == rows.size && !it.hasBrokenRows }
            ?.let { return FittedProgram(it.size, it.lines, it.boxes) }
        val fits = SIZES.asSequence().flatMap { size -> (1..MAX_COLUMNS).map { place(area, size, it) } }
            .filter { it.placed == rows.size }
        // Blocks that take one line each are worth more than larger letters in narrower columns.
        (fits.firstOrNull { !it.hasBrokenRows } ?: fits.firstOrNull())?.let {
            return FittedProgram(it.size, it.lines, it.boxes)
        }
        val most = (1..MAX_COLUMNS).map { place(area, SMALLEST, it, isCut = true) }.maxBy { it.placed }
        most.say(moreLines(groups.flatten().drop(most.placed).count { !it.isBlank }))
        return FittedProgram(SMALLEST, most.lines, most.boxes)
    }

    private fun place(area: PosterArea, size: Double, columns: Int, isCut: Boolean = false): PlacedRows {
        val placed = PlacedRows(area, size, columns, if (isCut) size * LINE_HEIGHT else 0.0)
        for (group in groups) if (!placed.add(group)) break
        return placed
    }
}

/** Rows of blocks in columns of [area], one below the other; [kept] is free below the last column. */
private class PlacedRows(
    private val area: PosterArea,
    val size: Double,
    private val columns: Int,
    private val kept: Double,
) {
    val lines = mutableListOf<PosterLine>()
    val boxes = mutableListOf<PosterBox>()

    /** How many rows have found room. */
    var placed = 0
        private set

    /** Whether any row takes several lines. */
    var hasBrokenRows = false
        private set
    private val width = columnWidth(area, columns)
    private var column = 0
    private var top = 0.0

    private val bottom: Double get() = area.height - (if (column == columns - 1) kept else 0.0)

    /** Whether there is room for all of [group], which is in one column if it can be. */
    fun add(group: List<PosterRow>): Boolean {
        val flows = group.map { it.flow(width / size) }
        val height = flows.sumOf { it.height } * size
        if (top + height > bottom && column < columns - 1 && height <= area.height - kept) goOn()
        return flows.all(::add)
    }

    private fun goOn() {
        column++
        top = 0.0
    }

    private fun add(flow: RowFlow): Boolean {
        // An empty line at the top of a column separates nothing.
        val height = if (top == 0.0 && flow.boxes.isEmpty()) 0.0 else flow.height * size
        if (top + height > bottom) {
            if (column == columns - 1 || height > area.height - kept) return false
            goOn()
        }
        val left = area.left + column * (width + GAP)
        flow.boxes.mapTo(boxes) { it.copy(area = it.area.onPage(left), corner = it.corner * size) }
        flow.words.mapTo(lines) { word ->
            val baseline = area.top + top + word.baseline * size
            val runs = listOf(PosterRun(word.text, word.colour))
            PosterLine(left + word.left * size, baseline, size, isCode = true, isBold = false, runs)
        }
        top += height
        placed++
        hasBrokenRows = hasBrokenRows || flow.isBroken
        return true
    }

    /** Writes [words] below the last row. */
    fun say(words: String) {
        val left = area.left + column * (width + GAP)
        val runs = listOf(PosterRun(words, QUIET_COLOUR))
        lines += PosterLine(left, area.top + top + size, size, isCode = true, isBold = false, runs)
    }

    private fun PosterArea.onPage(from: Double) =
        PosterArea(from + left * size, area.top + this@PlacedRows.top + top * size, width * size, height * size)
}
