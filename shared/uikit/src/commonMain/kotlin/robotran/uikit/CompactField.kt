package robotran.uikit

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.error
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.input.KeyboardType
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp

/**
 * What a [CompactField] says besides its text.
 *
 * @property wrong the error in the text, for screen readers; null if there is none.
 * @property hint the placeholder for empty text.
 */
class FieldWords(val label: String, val tag: String, val wrong: String? = null, val hint: String = "")

/** [TALL] shows several lines. */
enum class CompactFieldKind { LINE, TALL, NUMBER }

/**
 * A field for dense forms and bars, where its label is beside it or in its hint.
 *
 * @param style by default that of the kit's texts.
 * @param onLeft called when it loses the focus.
 */
@Composable
fun CompactField(
    text: String,
    words: FieldWords,
    modifier: Modifier = Modifier,
    kind: CompactFieldKind = CompactFieldKind.LINE,
    style: TextStyle = TextStyles.body,
    onLeft: () -> Unit = {},
    onText: (String) -> Unit,
) {
    val colours = LocalRobotranColours.current
    val isNumber = kind == CompactFieldKind.NUMBER
    Box(modifier.fieldFrame(words.wrong != null), Alignment.Center) {
        BasicTextField(
            text,
            onText,
            Modifier
                .fillMaxWidth()
                .padding(horizontal = if (isNumber) NUMBER_MARGIN else 8.dp, vertical = 10.dp)
                .testTag(words.tag)
                .left(onLeft)
                .semantics {
                    contentDescription = words.label
                    words.wrong?.let { error(it) }
                },
            textStyle = style.copy(colours.onPane, textAlign = if (isNumber) TextAlign.Center else TextAlign.Start),
            keyboardOptions = KeyboardOptions(
                keyboardType = if (isNumber) KeyboardType.Decimal else KeyboardType.Text,
            ),
            singleLine = kind != CompactFieldKind.TALL,
            minLines = if (kind == CompactFieldKind.TALL) TALL_LINES else 1,
            cursorBrush = SolidColor(colours.onPane),
        ) { inner ->
            if (text.isEmpty() && words.hint.isNotEmpty()) {
                val lines = if (kind == CompactFieldKind.TALL) Int.MAX_VALUE else 1
                Text(words.hint, style = style, color = colours.quiet, maxLines = lines)
            }
            inner()
        }
    }
}

/** The error below a field. */
@Composable
fun FieldError(text: String, modifier: Modifier = Modifier) =
    Text(text, modifier.announced(), TextStyles.small, color = LocalRobotranColours.current.error)

@Composable
private fun Modifier.left(onLeft: () -> Unit): Modifier {
    var focused by remember { mutableStateOf(false) }
    return onFocusChanged {
        if (focused && !it.isFocused) onLeft()
        focused = it.isFocused
    }
}

@Composable
private fun Modifier.fieldFrame(isWrong: Boolean): Modifier {
    val colours = LocalRobotranColours.current
    return defaultMinSize(minHeight = Dimensions.TARGET)
        .focusRing(Corners.SMALL)
        .background(if (colours.isDark) colours.desk else colours.paper, Shapes.SMALL)
        .border(if (isWrong) 2.dp else 1.dp, if (isWrong) colours.error else colours.quiet, Shapes.SMALL)
}

private const val TALL_LINES = 4

/** Leaves room for numbers such as `118.75`. */
private val NUMBER_MARGIN = 2.dp
