package robotran.uikit

import androidx.compose.runtime.Composable
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.TextUnit

/**
 * The styles of text by role: a size of [TextSizes] and one of [LineHeights]. [medium] and [strong] are heavier. Where
 * none of a role has a line height, it is that of the component around it.
 */
object TextStyles {
    val sign = style(TextSizes.SIGN)

    /** Below a sign, in several lines. */
    val signLines = style(TextSizes.SIGN, LineHeights.SIGN)

    val small = style(TextSizes.SMALL)

    /** A sentence of help. */
    val smallLines = style(TextSizes.SMALL, LineHeights.SMALL)

    /** A sentence right below what it is about. */
    val caption = style(TextSizes.SMALL, LineHeights.TIGHT)

    val compact = style(TextSizes.COMPACT)
    val compactLines = style(TextSizes.COMPACT, LineHeights.COMPACT)

    /** Sentences in a dense list. */
    val denseLines = style(TextSizes.COMPACT, LineHeights.SMALL)

    val body = style(TextSizes.BODY)

    /** Some words that may need a second line. */
    val label = style(TextSizes.BODY, LineHeights.LABEL)

    /** Sentences to read. */
    val sentence = style(TextSizes.BODY, LineHeights.BODY)

    /** Two lines in a narrow place. */
    val tightLabel = style(TextSizes.BODY, LineHeights.SMALL)

    val lead = style(TextSizes.LEAD)

    /** A title of a card. */
    val cardTitle = style(TextSizes.LEAD, LineHeights.BODY)

    /** A sentence to begin with. */
    val leadSentence = style(TextSizes.LEAD, LineHeights.LEAD)

    val heading = style(TextSizes.HEADING)

    /** A sentence that greets. */
    val headingLines = style(TextSizes.HEADING, LineHeights.HEADING)

    /** The title of a dialog. */
    val dialogTitle = style(TextSizes.HEADING, LineHeights.LEAD, FontWeight.Medium)

    val title = style(TextSizes.TITLE)

    /** The title of a page. */
    val pageTitle = style(TextSizes.TITLE, LineHeights.HEADING, FontWeight.SemiBold)

    /** Program text, see [codeStyle]. */
    val code: TextStyle
        @Composable
        get() = codeStyle()

    /** Words in a drawing of which each [unit] is so large: [size] and [lines] are units. */
    @Composable
    fun scaled(unit: Dp, size: Float, lines: Float = Float.NaN): TextStyle = with(LocalDensity.current) {
        TextStyle(
            fontSize = (unit * size).toSp(),
            lineHeight = if (lines.isNaN()) TextUnit.Unspecified else (unit * lines).toSp(),
        )
    }

    private fun style(size: TextUnit, lines: TextUnit = TextUnit.Unspecified, weight: FontWeight? = null) =
        TextStyle(fontSize = size, lineHeight = lines, fontWeight = weight)
}

/** What stands out a little, such as words on buttons. */
val TextStyle.medium: TextStyle get() = copy(fontWeight = FontWeight.Medium)

/** Titles, and what matters in a row. */
val TextStyle.strong: TextStyle get() = copy(fontWeight = FontWeight.SemiBold)

/** This style, heavier [on] condition. */
fun TextStyle.strongIf(on: Boolean, otherwise: FontWeight = FontWeight.Normal): TextStyle =
    copy(fontWeight = if (on) FontWeight.SemiBold else otherwise)
