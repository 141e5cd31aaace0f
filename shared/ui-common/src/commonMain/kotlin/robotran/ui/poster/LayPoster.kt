package robotran.ui.poster

import robotran.ui.poster.messages.PosterMessages
import robotran.workshop.state.Poster
import robotran.world.Paper
import kotlin.math.ceil

/**
 * Arranges [poster] on a page of A4, upright or across: whichever shows the program in larger letters, and the drawing
 * larger, if the letters are large enough either way. A program that does not fit at the smallest size is cut off, and
 * the last line says so.
 */
internal fun layPoster(poster: Poster): PosterPage {
    val code = codeLines(poster.program)
    val candidates = listOf(upright(poster.world.paper), across(poster.world.paper)).map {
        it to fitCode(code, it.code)
    }
    val (frame, fit) = candidates.maxWith(
        compareBy({ (_, fit) ->
            minOf(fit.size, COMFORTABLE)
        }, { (frame, _) -> frame.sheet.width * frame.sheet.height }),
    )
    return PosterPage(frame.width, frame.height, frame.sheet, headLines(poster, frame) + codeLines(poster, fit, frame))
}

/** A page with the places of drawing and program. */
private class PosterFrame(val width: Double, val height: Double, val sheet: PosterArea, val code: PosterArea)

/** The drawing above the program. */
private fun upright(paper: Paper): PosterFrame {
    val room = PosterArea(MARGIN, TOP, SHORT - 2 * MARGIN, (LONG - TOP - MARGIN) * SHEET_PART)
    val sheet = fitted(paper, room).let { it.copy(left = (SHORT - it.width) / 2) }
    val top = sheet.top + sheet.height + GAP
    return PosterFrame(SHORT, LONG, sheet, PosterArea(MARGIN, top, SHORT - 2 * MARGIN, LONG - MARGIN - top))
}

/** The drawing at the left of the program. */
private fun across(paper: Paper): PosterFrame {
    val room = PosterArea(MARGIN, TOP, (LONG - 2 * MARGIN) * SHEET_PART, SHORT - TOP - MARGIN)
    val sheet = fitted(paper, room)
    val left = sheet.left + sheet.width + GAP
    return PosterFrame(LONG, SHORT, sheet, PosterArea(left, TOP, LONG - MARGIN - left, SHORT - TOP - MARGIN))
}

private fun fitted(paper: Paper, room: PosterArea): PosterArea {
    val scale = minOf(room.width / paper.width, room.height / paper.height)
    return PosterArea(room.left, room.top, paper.width * scale, paper.height * scale)
}

/** How the program fits: the [lines] after wrapping, in [columns] columns, with letters of [size]. */
private class CodeFit(val size: Double, val columns: Int, val lines: List<List<PosterRun>>, val rows: Int)

private fun fitCode(code: List<List<PosterRun>>, area: PosterArea): CodeFit {
    for (step in 0..SIZE_STEPS) {
        val size = LARGEST - step * (LARGEST - SMALLEST) / SIZE_STEPS
        for (columns in 1..MAX_COLUMNS) fitCode(code, area, size, columns).takeIf { it.fits }?.let { return it }
    }
    return (1..MAX_COLUMNS).map { fitCode(code, area, SMALLEST, it) }.maxBy { it.rows * it.columns }
}

private val CodeFit.fits: Boolean get() = lines.size <= rows * columns

private fun fitCode(code: List<List<PosterRun>>, area: PosterArea, size: Double, columns: Int): CodeFit {
    val characters = (columnWidth(area, columns) / (size * CODE_ADVANCE)).toInt().coerceAtLeast(MIN_CHARACTERS)
    val rows = (area.height / (size * LINE_HEIGHT)).toInt()
    return CodeFit(size, columns, code.flatMap { wrapped(it, characters) }, rows)
}

private fun columnWidth(area: PosterArea, columns: Int) = (area.width - (columns - 1) * GAP) / columns

private fun codeLines(poster: Poster, fit: CodeFit, frame: PosterFrame): List<PosterLine> {
    val room = fit.rows * fit.columns
    val shown = if (fit.fits) {
        fit.lines
    } else {
        val more = PosterMessages.of(poster.language).moreLines(fit.lines.size - room + 1)
        fit.lines.take(room - 1) + listOf(listOf(PosterRun(more, QUIET_COLOUR)))
    }
    // Columns of about the same length look better than a full one beside an empty one.
    val perColumn = ceil(shown.size / fit.columns.toDouble()).toInt().coerceIn(1, fit.rows)
    return shown.mapIndexed { index, runs ->
        val left = frame.code.left + (index / perColumn) * (columnWidth(frame.code, fit.columns) + GAP)
        val baseline = frame.code.top + (index % perColumn) * fit.size * LINE_HEIGHT + fit.size
        PosterLine(left, baseline, fit.size, isCode = true, isBold = false, runs)
    }.filter { it.text.isNotBlank() }
}

/** Title, and below it who made it and when. */
private fun headLines(poster: Poster, frame: PosterFrame): List<PosterLine> {
    val width = frame.width - 2 * MARGIN
    val below = listOf(poster.maker, poster.date).filter { it.isNotBlank() }.joinToString(" · ")
    return listOf(Triple(poster.title, TITLE_BASELINE, TITLE_SIZE), Triple(below, BELOW_BASELINE, BELOW_SIZE))
        .filter { (words, _, _) -> words.isNotBlank() }
        .map { (words, baseline, size) ->
            val isTitle = size == TITLE_SIZE
            val fitting = minOf(size, width / (words.length * LETTER_ADVANCE))
            val run = PosterRun(words, if (isTitle) TITLE_COLOUR else QUIET_COLOUR)
            PosterLine(MARGIN, baseline, fitting, isCode = false, isBold = isTitle, listOf(run))
        }
}

/** A4 in millimetres (ISO 216). */
private const val SHORT = 210.0
private const val LONG = 297.0

/** Most printers leave less than this blank. */
private const val MARGIN = 12.0
private const val GAP = 8.0
private const val TITLE_SIZE = 9.0
private const val TITLE_BASELINE = 20.0
private const val BELOW_SIZE = 4.5
private const val BELOW_BASELINE = 27.5

/** Where drawing and program begin. */
private const val TOP = 33.0

/** The part of the page's height, or width, that the drawing may take. */
private const val SHEET_PART = 0.58

/** Letters for the program: 12 to 5.5 points. */
private const val LARGEST = 4.2
private const val SMALLEST = 1.95
private const val SIZE_STEPS = 18

/** 9 points: above, a larger drawing is worth more than larger letters. */
private const val COMFORTABLE = 3.2
private const val MAX_COLUMNS = 3
private const val MIN_CHARACTERS = 12
internal const val LINE_HEIGHT = 1.35

/** The width of a letter, in heights of the font: JetBrains Mono, DejaVu Sans Mono, Menlo and Courier have 0.6. */
internal const val CODE_ADVANCE = 0.605

/** A mean that texts in bold sans serif fonts seldom exceed. */
private const val LETTER_ADVANCE = 0.6
