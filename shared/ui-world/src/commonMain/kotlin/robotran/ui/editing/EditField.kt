package robotran.ui.editing

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
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
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.error
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.input.KeyboardType
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import robotran.uikit.*

/** The box around [field]. */
@Composable
internal fun EditFieldBox(isWrong: Boolean, modifier: Modifier, field: @Composable () -> Unit) {
    val colours = LocalRobotranColours.current
    Box(
        modifier
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .focusRing(FIELD_CORNER)
            .background(if (colours.isDark) colours.desk else colours.paper, RoundedCornerShape(FIELD_CORNER))
            .border(
                if (isWrong) 2.dp else 1.dp,
                if (isWrong) colours.error else colours.quiet,
                RoundedCornerShape(FIELD_CORNER),
            ),
        Alignment.Center,
    ) { field() }
}

/**
 * What an input says besides its text.
 *
 * @property wrong the error in the text, for screen readers; null if there is none.
 * @property hint the placeholder for empty text.
 */
internal class FieldWords(val label: String, val tag: String, val wrong: String?, val hint: String = "")

internal enum class EditFieldKind { LINE, TALL, NUMBER }

/**
 * An input for a text.
 *
 * @param onLeft called when it loses the focus.
 */
@Composable
internal fun EditField(
    text: String,
    words: FieldWords,
    kind: EditFieldKind,
    onText: (String) -> Unit,
    onLeft: () -> Unit,
) {
    val colours = LocalRobotranColours.current
    var focused by remember { mutableStateOf(false) }
    BasicTextField(
        value = text,
        onValueChange = onText,
        modifier = Modifier
            .fillMaxWidth()
            .padding(horizontal = if (kind == EditFieldKind.NUMBER) NUMBER_MARGIN else 8.dp, vertical = 10.dp)
            .testTag(words.tag)
            .onFocusChanged {
                if (focused && !it.isFocused) onLeft()
                focused = it.isFocused
            }
            .semantics {
                contentDescription = words.label
                words.wrong?.let { error(it) }
            },
        textStyle = TextStyle(
            colours.onPane,
            fontSize = TextSizes.BODY,
            textAlign = if (kind == EditFieldKind.NUMBER) TextAlign.Center else TextAlign.Start,
        ),
        keyboardOptions = KeyboardOptions(
            keyboardType = if (kind == EditFieldKind.NUMBER) KeyboardType.Decimal else KeyboardType.Text,
        ),
        singleLine = kind != EditFieldKind.TALL,
        minLines = if (kind == EditFieldKind.TALL) TALL_LINES else 1,
        cursorBrush = SolidColor(colours.onPane),
        decorationBox = { inner ->
            if (text.isEmpty() &&
                words.hint.isNotEmpty()
            ) {
                Text(words.hint, style = TextStyles.body, color = colours.quiet)
            }
            inner()
        },
    )
}

/** The error below a field. */
@Composable
internal fun Wrong(text: String, modifier: Modifier = Modifier) = Text(
    text,
    modifier.announced(),
    TextStyles.small,
    color = LocalRobotranColours.current.error,
)

private val FIELD_CORNER = Corners.SMALL
private const val TALL_LINES = 4

/** Leaves room for numbers such as `118.75`. */
private val NUMBER_MARGIN = 2.dp
