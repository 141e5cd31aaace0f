package robotran.ui.program

import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.focus.FocusDirection
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextLayoutResult
import androidx.compose.ui.text.TextRange
import androidx.compose.ui.text.input.KeyboardCapitalization
import androidx.compose.ui.text.input.TextFieldValue
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.robolang.SourceRange
import robotran.ui.resources.Res
import robotran.ui.resources.program_label
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.codeStyle

/**
 * The program to write in, with line numbers.
 *
 * @param hint what stands there as long as there is no text.
 * @param runningLine the line to mark as running, from 1; 0 for none.
 * @param mistakes the places to underline.
 */
@Composable
internal fun ProgramEditor(
    text: String,
    hint: String,
    runningLine: Int,
    mistakes: List<SourceRange>,
    onEdit: (String) -> Unit,
    modifier: Modifier = Modifier,
) {
    BoxWithConstraints(modifier) {
        val least = maxHeight
        Row(Modifier.fillMaxSize().verticalScroll(rememberScrollState()).padding(vertical = 12.dp)) {
            LineNumbers(text.count { it == '\n' } + 1, mistakes.mapTo(mutableSetOf()) { it.line })
            BoxWithConstraints(Modifier.weight(1f)) {
                val width = maxWidth
                Box(Modifier.horizontalScroll(rememberScrollState())) {
                    ProgramField(text, hint, runningLine, mistakes, onEdit, Modifier.defaultMinSize(width, least))
                }
            }
        }
    }
}

@Composable
private fun ProgramField(
    text: String,
    hint: String,
    runningLine: Int,
    mistakes: List<SourceRange>,
    onEdit: (String) -> Unit,
    modifier: Modifier,
) {
    val colours = LocalRobotranColours.current
    val label = stringResource(Res.string.program_label)
    var value by remember { mutableStateOf(TextFieldValue(text)) }
    if (value.text != text) value = value.copy(text = text, selection = TextRange(value.selection.end.coerceAtMost(text.length)))
    var layout by remember { mutableStateOf<TextLayoutResult?>(null) }
    BasicTextField(
        value = value,
        onValueChange = {
            value = it
            onEdit(it.text)
        },
        modifier = modifier
            .testTag("program")
            .semantics { contentDescription = label }
            .leaveByTab()
            .drawBehind { layout?.let { drawProgramMarks(it, runningLine, mistakes, colours) } },
        textStyle = codeStyle(),
        cursorBrush = SolidColor(colours.focus),
        keyboardOptions = KeyboardOptions(capitalization = KeyboardCapitalization.None, autoCorrectEnabled = false),
        onTextLayout = { layout = it },
        decorationBox = { field ->
            if (text.isEmpty()) Text(hint, style = codeStyle(colours.quiet))
            field()
        },
    )
}

/** Tab goes to what comes next, as everywhere else on the screen: who cannot use a mouse must be able to get out of the text. */
@Composable
private fun Modifier.leaveByTab(): Modifier {
    val focus = LocalFocusManager.current
    return onPreviewKeyEvent { event ->
        val tab = event.key == Key.Tab
        if (tab && event.type == KeyEventType.KeyDown) {
            focus.moveFocus(if (event.isShiftPressed) FocusDirection.Previous else FocusDirection.Next)
        }
        tab
    }
}
