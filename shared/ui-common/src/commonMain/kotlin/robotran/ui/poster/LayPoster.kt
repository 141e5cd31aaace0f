package robotran.ui.poster

import robotran.ui.poster.messages.PosterMessages
import robotran.workshop.state.Poster

/**
 * Arranges [poster] on a page of A4, upright or across: whichever shows the program in larger letters, and the drawing
 * larger, if the letters are large enough either way. A program that does not fit at the smallest size is cut off, and
 * the last line says so.
 */
internal fun layPoster(poster: Poster): PosterPage {
    val program = poster.blocks?.let { ProgramInBlocks(it) } ?: ProgramInText(poster.program)
    val words = PosterMessages.of(poster.language)
    val candidates = listOf(upright(poster), across(poster)).map { it to program.fitted(it.code, words::moreLines) }
    val (frame, fit) = candidates.maxWith(
        compareBy({ (_, fit) ->
            minOf(fit.size, COMFORTABLE)
        }, { (frame, _) -> frame.sheet.width * frame.sheet.height }),
    )
    return PosterPage(
        frame.width,
        frame.height,
        frame.sheet,
        frame.crop,
        fit.boxes,
        headLines(poster, frame) + fit.lines,
    )
}

/** A program in its place on a page, with letters of [size]. */
internal class FittedProgram(val size: Double, val lines: List<PosterLine>, val boxes: List<PosterBox> = emptyList())

/** A program as it is shown on a page. */
internal interface PosterProgram {
    /** The program in [area], in letters as large as they can be. [moreLines] says how many lines had no room. */
    fun fitted(area: PosterArea, moreLines: (Int) -> String): FittedProgram
}

/** A page with the places of drawing and program, and the part of the paper that is seen. */
private class PosterFrame(
    val width: Double,
    val height: Double,
    val sheet: PosterArea,
    val crop: PosterArea,
    val code: PosterArea,
)

/** The drawing above the program. */
private fun upright(poster: Poster): PosterFrame {
    val room = PosterArea(MARGIN, TOP, SHORT - 2 * MARGIN, (LONG - TOP - MARGIN) * SHEET_PART)
    val crop = cropOf(poster.world, poster.session, room.width / room.height)
    val sheet = fitted(crop, room).let { it.copy(left = (SHORT - it.width) / 2) }
    val top = sheet.top + sheet.height + GAP
    return PosterFrame(SHORT, LONG, sheet, crop, PosterArea(MARGIN, top, SHORT - 2 * MARGIN, LONG - MARGIN - top))
}

/** The drawing at the left of the program. */
private fun across(poster: Poster): PosterFrame {
    val room = PosterArea(MARGIN, TOP, (LONG - 2 * MARGIN) * SHEET_PART, SHORT - TOP - MARGIN)
    val crop = cropOf(poster.world, poster.session, room.width / room.height)
    val sheet = fitted(crop, room)
    val left = sheet.left + sheet.width + GAP
    return PosterFrame(LONG, SHORT, sheet, crop, PosterArea(left, TOP, LONG - MARGIN - left, SHORT - TOP - MARGIN))
}

private fun fitted(crop: PosterArea, room: PosterArea): PosterArea {
    val scale = minOf(room.width / crop.width, room.height / crop.height)
    return PosterArea(room.left, room.top, crop.width * scale, crop.height * scale)
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
internal const val GAP = 8.0
private const val TITLE_SIZE = 9.0
private const val TITLE_BASELINE = 20.0
private const val BELOW_SIZE = 4.5
private const val BELOW_BASELINE = 27.5

/** Where drawing and program begin. */
private const val TOP = 33.0

/** The part of the page's height, or width, that the drawing may take. */
private const val SHEET_PART = 0.58

/** 9 points: above, a larger drawing is worth more than larger letters. */
private const val COMFORTABLE = 3.2

/** A mean that texts in bold sans serif fonts seldom exceed. */
private const val LETTER_ADVANCE = 0.6
