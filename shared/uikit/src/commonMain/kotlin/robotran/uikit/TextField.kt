package robotran.uikit

import androidx.compose.foundation.text.KeyboardActions
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.material3.OutlinedTextField
import androidx.compose.material3.OutlinedTextFieldDefaults
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Shape
import androidx.compose.ui.text.input.TextFieldValue

/**
 * A field for a text.
 *
 * @param label its name, above the text.
 * @param lines how many lines it shows; in one of a single line there are no others.
 */
@Composable
fun TextField(
    text: String,
    onChange: (String) -> Unit,
    modifier: Modifier = Modifier,
    label: String? = null,
    lines: IntRange = 1..1,
    keyboard: KeyboardOptions = KeyboardOptions.Default,
    onKeyboard: KeyboardActions = KeyboardActions.Default,
    extras: FieldExtras = FieldExtras(),
) = OutlinedTextField(
    text,
    onChange,
    modifier,
    readOnly = extras.isReadOnly,
    label = words(label),
    placeholder = words(extras.placeholder, maxLines = 1),
    trailingIcon = extras.button,
    suffix = words(extras.suffix),
    supportingText = extras.help,
    isError = extras.isError,
    keyboardOptions = keyboard,
    keyboardActions = onKeyboard,
    singleLine = lines.last == 1,
    minLines = lines.first,
    maxLines = lines.last,
    shape = extras.shape,
    colors = colours(),
)

/** The same with a selection. */
@Composable
fun TextField(
    text: TextFieldValue,
    onChange: (TextFieldValue) -> Unit,
    modifier: Modifier = Modifier,
    label: String? = null,
    lines: IntRange = 1..1,
    keyboard: KeyboardOptions = KeyboardOptions.Default,
    onKeyboard: KeyboardActions = KeyboardActions.Default,
    extras: FieldExtras = FieldExtras(),
) = OutlinedTextField(
    text,
    onChange,
    modifier,
    readOnly = extras.isReadOnly,
    label = words(label),
    placeholder = words(extras.placeholder, maxLines = 1),
    trailingIcon = extras.button,
    suffix = words(extras.suffix),
    supportingText = extras.help,
    isError = extras.isError,
    keyboardOptions = keyboard,
    keyboardActions = onKeyboard,
    singleLine = lines.last == 1,
    minLines = lines.first,
    maxLines = lines.last,
    shape = extras.shape,
    colors = colours(),
)

/**
 * What only some fields have.
 *
 * @property placeholder what is read in the empty field.
 * @property suffix what stands behind the text.
 * @property help below the field.
 * @property button at the end of the field.
 */
class FieldExtras(
    val isError: Boolean = false,
    val isReadOnly: Boolean = false,
    val placeholder: String? = null,
    val suffix: String? = null,
    val shape: Shape = Shapes.TINY,
    val button: (@Composable () -> Unit)? = null,
    val help: (@Composable () -> Unit)? = null,
)

private fun words(text: String?, maxLines: Int = Int.MAX_VALUE): (@Composable () -> Unit)? =
    text?.let { { Text(it, maxLines = maxLines) } }

@Composable
private fun colours() = LocalRobotranColours.current.let {
    OutlinedTextFieldDefaults.colors(
        focusedBorderColor = it.focus,
        focusedLabelColor = it.focus,
        unfocusedBorderColor = it.quiet,
        unfocusedLabelColor = it.quiet,
        cursorColor = it.focus,
    )
}
