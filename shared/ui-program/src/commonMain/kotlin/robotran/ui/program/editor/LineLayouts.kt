package robotran.ui.program.editor

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.TextLayoutResult
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.sp
import robotran.brick.kind.BrickKind
import robotran.languagesupport.CodeSyntax
import robotran.textediting.rows.LineRows
import robotran.textediting.rows.rowsOf
import robotran.ui.code.CodeColours
import robotran.ui.code.codeColours
import robotran.uikit.*
import kotlin.math.ceil

/** The layouts of code lines, created on demand and cached. */
internal class LineLayouts(
    private val measurer: TextMeasurer,
    val style: TextStyle,
    private val colours: CodeColours,
    private val code: CodeSyntax,
    private val brick: BrickKind,
    density: Density,
) {
    private val kept = HashMap<LineKey, LaidOutLine>()

    /** The line height in pixels; an integer, so that text stays sharp. */
    val lineHeight: Float = with(density) { style.lineHeight.toPx() }.let { ceil(it) }

    /** The width of an average character in pixels. */
    val characterWidth: Float by lazy(LazyThreadSafetyMode.NONE) {
        measurer.measure(SAMPLE, style).size.width /
            SAMPLE.length.toFloat()
    }

    /** The layout of [text], broken into rows of at most [columns] characters. */
    fun of(text: String, startsInComment: Boolean, columns: Int): LaidOutLine {
        val key = LineKey(text, startsInComment, columns)
        kept[key]?.let { return it }
        if (kept.size >= MAX_CACHED) kept.clear()
        return layOut(text, startsInComment, columns).also { kept[key] = it }
    }

    private fun layOut(text: String, startsInComment: Boolean, columns: Int): LaidOutLine {
        val rows = rowsOf(text, columns)
        val spans = code.tokens(text, startsInComment, brick).tokens.map {
            AnnotatedString.Range(
                SpanStyle(colours.of(it.kind)),
                rows.shown.column(it.start),
                rows.shown.column(it.end),
            )
        }
        val coloured = AnnotatedString(rows.shown.text, spans)
        return LaidOutLine(rows, characterWidth) { from, to ->
            measurer.measure(coloured.subSequence(from, to), style, softWrap = false, maxLines = 1)
        }
    }

    private data class LineKey(val text: String, val startsInComment: Boolean, val columns: Int)

    private companion object {
        const val SAMPLE = "nnnnnnnnnnnnnnnnnnnn"

        /** More lines than any screen shows. */
        const val MAX_CACHED = 600
    }
}

/**
 * A line with the layouts of its rows, each made when it is first drawn.
 *
 * @param measure lays out a part of the shown text.
 */
internal class LaidOutLine(
    val rows: LineRows,
    private val characterWidth: Float,
    private val measure: (from: Int, to: Int) -> TextLayoutResult,
) {
    private val layouts = arrayOfNulls<TextLayoutResult>(rows.count)

    fun layout(row: Int): TextLayoutResult =
        layouts[row] ?: measure(rows.start(row), rows.end(row)).also { layouts[row] = it }

    /** Where the text of [row] begins, in pixels. */
    fun left(row: Int): Float = rows.indentOf(row) * characterWidth

    /** The x position of [column] in its row, in pixels. */
    fun x(column: Int): Float = rows.rowOf(column).let { row -> x(row, rows.shown.column(within(column))) }

    /** The column of [row] whose left edge is nearest to [x]. */
    fun column(row: Int, x: Float): Int {
        val offset = layout(row).getOffsetForPosition(Offset(x - left(row), 1f))
        return rows.columnOf(row, rows.start(row) + offset)
    }

    /** The pieces of the part from column [from] to before [to], one for each row that it is in. */
    fun pieces(from: Int, to: Int): List<RowPiece> {
        val start = rows.shown.column(within(from))
        val end = rows.shown.column(within(to))
        return (rows.rowOf(from)..rows.rowOf(to))
            .filter { row -> maxOf(start, rows.start(row)) < end || rows.start(row) <= start }
            .map { row -> RowPiece(row, x(row, maxOf(start, rows.start(row))), x(row, minOf(end, rows.end(row)))) }
    }

    private fun x(row: Int, place: Int): Float =
        left(row) + layout(row).getHorizontalPosition(place - rows.start(row), usePrimaryDirection = true)

    private fun within(column: Int) = column.coerceIn(0, rows.shown.length)
}

/** A part of a [row], from [left] to [right] in pixels. */
internal class RowPiece(val row: Int, val left: Float, val right: Float)

/** The line layouts of a program for a [brick], for a font size of [size] sp and the theme's colours. */
@Composable
internal fun rememberLineLayouts(code: CodeSyntax, brick: BrickKind, size: Float): LineLayouts {
    val measurer = rememberTextMeasurer(cacheSize = 0)
    val colours = codeColours()
    val density = LocalDensity.current
    val style = editorStyle(size)
    return remember(measurer, colours, density, style, code, brick) {
        LineLayouts(measurer, style, colours, code, brick, density)
    }
}

/** The text style of an editor with a font size of [size] sp. */
@Composable
internal fun editorStyle(size: Float): TextStyle =
    codeStyle().copy(fontSize = size.sp, lineHeight = (size * LINE_HEIGHT).sp)

private const val LINE_HEIGHT = 1.4f
