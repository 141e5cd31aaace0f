package robotran.ui.learning

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.text.withStyle
import robotran.uikit.*

/** A paragraph with program text between backticks, see [robotran.learning.LessonText]. */
@Composable
internal fun MarkedText(
    text: String,
    modifier: Modifier = Modifier,
    colour: Color = LocalRobotranColours.current.onPane,
    weight: FontWeight = FontWeight.Normal,
    maxLines: Int = Int.MAX_VALUE,
) {
    val code = codeStyle().run {
        SpanStyle(color = colour, fontFamily = fontFamily, fontFeatureSettings = fontFeatureSettings)
    }
    val background = LocalRobotranColours.current.desk
    Text(
        marked(text, code.copy(background = background)),
        modifier,
        TextStyles.sentence.copy(fontWeight = weight),
        color = colour,
        maxLines = maxLines,
        overflow = TextOverflow.Ellipsis,
    )
}

private fun marked(text: String, code: SpanStyle): AnnotatedString = buildAnnotatedString {
    text.split('`').forEachIndexed { place, part ->
        // A thin space on either side separates the code's background from the words.
        if (place % 2 == 1) withStyle(code) { append("\u2009${kept(part)}\u2009") } else append(part)
    }
}

/** Short code stays in one line; longer code may be broken at its blanks, or it would be broken within a word. */
private fun kept(code: String): String = if (code.length <= KEPT) code.replace(' ', '\u00A0') else code

/** Fits on a phone with the largest text. */
private const val KEPT = 16
