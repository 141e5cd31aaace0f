package robotran.ui.poster

import androidx.compose.ui.graphics.Color

/**
 * A poster with everything in its place. Lengths are millimetres from the page's upper left corner.
 *
 * @property sheet where the drawing is.
 * @property crop the part of the paper that is seen there, see [cropOf].
 * @property boxes what blocks of the program are drawn with, the lowest first; none for a program in text.
 * @property lines the texts, without overlaps.
 */
internal class PosterPage(
    val width: Double,
    val height: Double,
    val sheet: PosterArea,
    val crop: PosterArea,
    val boxes: List<PosterBox>,
    val lines: List<PosterLine>,
) {
    val isLandscape: Boolean get() = width > height
}

internal data class PosterArea(val left: Double, val top: Double, val width: Double, val height: Double)

/** A rectangle with round corners of this radius; [edge] is the colour of its outline, null for none. */
internal data class PosterBox(val area: PosterArea, val corner: Double, val fill: Color, val edge: Color? = null)

/**
 * A line of text.
 *
 * @property baseline where its letters stand.
 * @property size the height of its font.
 * @property isCode whether it is in the monospaced font.
 */
internal class PosterLine(
    val left: Double,
    val baseline: Double,
    val size: Double,
    val isCode: Boolean,
    val isBold: Boolean,
    val runs: List<PosterRun>,
) {
    val text: String get() = runs.joinToString("") { it.words }
}

/** A part of a line in one colour. */
internal data class PosterRun(val words: String, val colour: Color)
