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
import robotran.language.ProgramLanguage
import robotran.textediting.code.piecesOf
import robotran.ui.theme.codeStyle
import kotlin.math.ceil

/** How lines of code look: laid out when they are first needed, and kept for when they are drawn again. */
internal class LineLayouts(
    private val measurer: TextMeasurer,
    val style: TextStyle,
    private val colours: CodeColours,
    private val language: ProgramLanguage,
    density: Density,
) {
    private val kept = HashMap<LineKey, LaidOutLine>()

    /** Pixels from line to line, a whole number so that they stay sharp. */
    val lineHeight: Float = with(density) { style.lineHeight.toPx() }.let { ceil(it) }

    /** Pixels that an ordinary character takes. */
    val characterWidth: Float by lazy(LazyThreadSafetyMode.NONE) {
        measurer.measure(SAMPLE, style).size.width /
            SAMPLE.length.toFloat()
    }

    /** [text] as it is drawn. */
    fun of(text: String, startsInComment: Boolean): LaidOutLine {
        val key = LineKey(text, startsInComment)
        kept[key]?.let { return it }
        if (kept.size >= MAX_KEPT) kept.clear()
        return layOut(text, startsInComment).also { kept[key] = it }
    }

    private fun layOut(text: String, startsInComment: Boolean): LaidOutLine {
        val shown = ShownLine(text)
        val spans = piecesOf(text, language, startsInComment).map {
            AnnotatedString.Range(SpanStyle(colours.of(it.kind)), shown.column(it.start), shown.column(it.end))
        }
        return LaidOutLine(
            shown,
            measurer.measure(AnnotatedString(shown.text, spans), style, softWrap = false, maxLines = 1),
        )
    }

    private data class LineKey(val text: String, val startsInComment: Boolean)

    private companion object {
        const val SAMPLE = "nnnnnnnnnnnnnnnnnnnn"

        /** More lines than any screen shows. */
        const val MAX_KEPT = 600
    }
}

/** A line that was laid out. */
internal class LaidOutLine(private val shown: ShownLine, val layout: TextLayoutResult) {
    /** How far right [column] of the line is, in pixels. */
    fun x(column: Int): Float =
        layout.getHorizontalPosition(shown.column(column.coerceIn(0, shown.length)), usePrimaryDirection = true)

    /** The column whose left edge is nearest to [x]. */
    fun column(x: Float): Int {
        val offset = layout.getOffsetForPosition(Offset(x, 1f))
        return shown.sourceColumn(offset)
    }
}

/** A line with blanks in place of its tabs. */
internal class ShownLine(line: String) {
    val length: Int = line.length
    private val columns: IntArray? = if ('\t' in line) columnsOf(line) else null

    val text: String = if (columns == null) {
        line
    } else {
        buildString {
            line.forEachIndexed { index, character ->
                if (character == '\t') append(" ".repeat(columns[index + 1] - columns[index])) else append(character)
            }
        }
    }

    /** Where [column] of the line is in [text]. */
    fun column(column: Int): Int = columns?.get(column) ?: column

    /** The column of the line that [shown] of [text] belongs to. */
    fun sourceColumn(shown: Int): Int {
        val places = columns ?: return shown
        return places.indexOfLast { it <= shown }.coerceAtLeast(0)
    }

    private fun columnsOf(line: String): IntArray {
        val places = IntArray(line.length + 1)
        line.forEachIndexed { index, character ->
            places[index + 1] = if (character == '\t') (places[index] / TAB + 1) * TAB else places[index] + 1
        }
        return places
    }

    private companion object {
        const val TAB = 4
    }
}

/** Layouts for text of [size] sp in the colours of the theme. */
@Composable
internal fun rememberLineLayouts(language: ProgramLanguage, size: Float): LineLayouts {
    val measurer = rememberTextMeasurer(cacheSize = 0)
    val colours = codeColours()
    val density = LocalDensity.current
    val style = editorStyle(size)
    return remember(measurer, colours, density, style, language) {
        LineLayouts(measurer, style, colours, language, density)
    }
}

/** How the text of an editor is set, [size] in sp. */
@Composable
internal fun editorStyle(size: Float): TextStyle =
    codeStyle().copy(fontSize = size.sp, lineHeight = (size * LINE_HEIGHT).sp)

private const val LINE_HEIGHT = 1.4f
