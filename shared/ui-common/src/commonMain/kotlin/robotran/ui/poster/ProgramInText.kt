package robotran.ui.poster

import robotran.programs.Program
import kotlin.math.ceil

/** A program as text, in up to three columns. */
internal class ProgramInText(program: Program) : PosterProgram {
    private val code = codeLines(program)

    override fun fitted(area: PosterArea, moreLines: (Int) -> String): FittedProgram {
        val fit = fit(area)
        return FittedProgram(fit.size, linesOf(fit, area, moreLines))
    }

    private fun fit(area: PosterArea): CodeFit {
        for (size in LARGE_SIZES) fit(area, size, 1).takeIf { it.fits && it.lines.size == code.size }?.let { return it }
        for (size in SIZES) {
            for (columns in 1..MAX_COLUMNS) fit(area, size, columns).takeIf { it.fits }?.let { return it }
        }
        return (1..MAX_COLUMNS).map { fit(area, SMALLEST, it) }.maxBy { it.rows * it.columns }
    }

    private fun fit(area: PosterArea, size: Double, columns: Int): CodeFit {
        val characters = (columnWidth(area, columns) / (size * CODE_ADVANCE)).toInt().coerceAtLeast(MIN_CHARACTERS)
        val rows = (area.height / (size * LINE_HEIGHT)).toInt()
        return CodeFit(size, columns, code.flatMap { wrapped(it, characters) }, rows)
    }

    private fun linesOf(fit: CodeFit, area: PosterArea, moreLines: (Int) -> String): List<PosterLine> {
        val room = fit.rows * fit.columns
        val shown = if (fit.fits) {
            fit.lines
        } else {
            val more = moreLines(fit.lines.size - room + 1)
            fit.lines.take(room - 1) + listOf(listOf(PosterRun(more, QUIET_COLOUR)))
        }
        // Columns of about the same length look better than a full one beside an empty one.
        val perColumn = ceil(shown.size / fit.columns.toDouble()).toInt().coerceIn(1, fit.rows)
        return shown.mapIndexed { index, runs ->
            val left = area.left + (index / perColumn) * (columnWidth(area, fit.columns) + GAP)
            val baseline = area.top + (index % perColumn) * fit.size * LINE_HEIGHT + fit.size
            PosterLine(left, baseline, fit.size, isCode = true, isBold = false, runs)
        }.filter { it.text.isNotBlank() }
    }
}

/** How the program fits: the [lines] after wrapping, in [columns] columns, with letters of [size]. */
private class CodeFit(val size: Double, val columns: Int, val lines: List<List<PosterRun>>, val rows: Int) {
    val fits: Boolean get() = lines.size <= rows * columns
}

internal fun columnWidth(area: PosterArea, columns: Int) = (area.width - (columns - 1) * GAP) / columns

/** The sizes of letters for the program, 12 to 5.5 points, the largest first. */
internal val SIZES = List(19) { 4.2 - it * 0.125 }
internal val SMALLEST = SIZES.last()

/** 20 to 12 points, for a short program that has its room in one column without broken lines. */
internal val LARGE_SIZES = List(14) { 7.0 - it * 0.2 }
internal const val MAX_COLUMNS = 3
private const val MIN_CHARACTERS = 12
internal const val LINE_HEIGHT = 1.35

/** The width of a letter, in heights of the font: JetBrains Mono, DejaVu Sans Mono, Menlo and Courier have 0.6. */
internal const val CODE_ADVANCE = 0.605
