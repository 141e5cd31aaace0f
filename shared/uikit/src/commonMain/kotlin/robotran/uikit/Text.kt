package robotran.uikit

import androidx.compose.foundation.text.BasicText
import androidx.compose.material3.LocalContentColor
import androidx.compose.material3.LocalTextStyle
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.takeOrElse
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow

/**
 * Words on the screen.
 *
 * @param style one of [TextStyles], which is laid over the style of the component that it is in.
 * @param color by default that of the style, or of the component.
 */
@Composable
fun Text(
    text: String,
    modifier: Modifier = Modifier,
    style: TextStyle = TextStyle.Default,
    color: Color = Color.Unspecified,
    textAlign: TextAlign = TextAlign.Unspecified,
    maxLines: Int = Int.MAX_VALUE,
    overflow: TextOverflow = TextOverflow.Clip,
    softWrap: Boolean = true,
) {
    val whole = style.asWritten(color, textAlign)
    BasicText(text, modifier, whole, overflow = overflow, softWrap = softWrap, maxLines = maxLines)
}

/** The same with parts in other styles. */
@Composable
fun Text(
    text: AnnotatedString,
    modifier: Modifier = Modifier,
    style: TextStyle = TextStyle.Default,
    color: Color = Color.Unspecified,
    textAlign: TextAlign = TextAlign.Unspecified,
    maxLines: Int = Int.MAX_VALUE,
    overflow: TextOverflow = TextOverflow.Clip,
    softWrap: Boolean = true,
) {
    val whole = style.asWritten(color, textAlign)
    BasicText(text, modifier, whole, overflow = overflow, softWrap = softWrap, maxLines = maxLines)
}

/** This style as a [Text] has it at this place, for measuring. */
@Composable
fun TextStyle.asWritten(color: Color = Color.Unspecified, textAlign: TextAlign = TextAlign.Unspecified): TextStyle {
    val whole = LocalTextStyle.current.merge(this)
    val colour = color.takeOrElse { whole.color.takeOrElse { LocalContentColor.current } }
    return whole.merge(color = colour, textAlign = textAlign)
}
