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
import robotran.language.ProgramLanguage
import robotran.programs.support
import robotran.ui.code.CodeColours
import robotran.ui.code.codeColours
import robotran.uikit.*
import kotlin.math.ceil

/** The layouts of code lines, created on demand and cached. */
internal class LineLayouts(
    private val measurer: TextMeasurer,
    val style: TextStyle,
    private val colours: CodeColours,
    private val language: ProgramLanguage,
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

    /** The layout of [text]. */
    fun of(text: String, startsInComment: Boolean): LaidOutLine {
        val key = LineKey(text, startsInComment)
        kept[key]?.let { return it }
        if (kept.size >= MAX_CACHED) kept.clear()
        return layOut(text, startsInComment).also { kept[key] = it }
    }

    private fun layOut(text: String, startsInComment: Boolean): LaidOutLine {
        val shown = ShownLine(text)
        val spans = language.support.code.tokens(text, startsInComment, brick).tokens.map {
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
        const val MAX_CACHED = 600
    }
}

/** A line with its layout. */
internal class LaidOutLine(private val shown: ShownLine, val layout: TextLayoutResult) {
    /** The x position of [column] in pixels. */
    fun x(column: Int): Float =
        layout.getHorizontalPosition(shown.column(column.coerceIn(0, shown.length)), usePrimaryDirection = true)

    /** The column whose left edge is nearest to [x]. */
    fun column(x: Float): Int {
        val offset = layout.getOffsetForPosition(Offset(x, 1f))
        return shown.sourceColumn(offset)
    }
}

/** A line with its tabs expanded to spaces. */
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

    /** The index of [column] in [text]. */
    fun column(column: Int): Int = columns?.get(column) ?: column

    /** The column for the index [shown] in [text]. */
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

/** The line layouts of a program for a [brick], for a font size of [size] sp and the theme's colours. */
@Composable
internal fun rememberLineLayouts(language: ProgramLanguage, brick: BrickKind, size: Float): LineLayouts {
    val measurer = rememberTextMeasurer(cacheSize = 0)
    val colours = codeColours()
    val density = LocalDensity.current
    val style = editorStyle(size)
    return remember(measurer, colours, density, style, language, brick) {
        LineLayouts(measurer, style, colours, language, brick, density)
    }
}

/** The text style of an editor with a font size of [size] sp. */
@Composable
internal fun editorStyle(size: Float): TextStyle =
    codeStyle().copy(fontSize = size.sp, lineHeight = (size * LINE_HEIGHT).sp)

private const val LINE_HEIGHT = 1.4f
