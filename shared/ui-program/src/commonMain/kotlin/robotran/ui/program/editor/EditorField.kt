package robotran.ui.program.editor

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.alpha
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.layout.layout
import androidx.compose.ui.text.TextRange
import androidx.compose.ui.text.input.KeyboardCapitalization
import androidx.compose.ui.text.input.TextFieldValue
import androidx.compose.ui.unit.Constraints
import robotran.language.source.SourceSpan
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection

/**
 * The hidden input field. It holds the part of [draft] around the caret and lies at the caret, so that input methods
 * show their suggestions there and screen readers read it.
 *
 * @param caret where the caret is drawn.
 * @param onComposing receives the text that an input method is composing.
 */
@Composable
internal fun EditorField(
    draft: TextDocument,
    control: EditorControl,
    layouts: LineLayouts,
    caret: () -> Rect,
    onComposing: (SourceSpan?) -> Unit,
    modifier: Modifier = Modifier,
) {
    val field = control.link.fieldFor(draft)
    var last by remember(control) { mutableStateOf(TextFieldValue()) }
    val value = TextFieldValue(field.text, TextRange(field.selection.anchor, field.selection.caret))
    val shown = if (value.text == last.text && value.selection == last.selection) last else value
    BasicTextField(
        value = shown,
        onValueChange = {
            last = it
            val written = TextDocument(it.text, TextSelection(it.selection.start, it.selection.end))
            control.received(written, isComposing = it.composition != null)
            onComposing(
                it.composition?.let { span ->
                    SourceSpan(
                        control.link.start + span.min,
                        control.link.start + span.max,
                    )
                },
            )
        },
        modifier = modifier,
        textStyle = layouts.style.copy(color = Color.Transparent),
        cursorBrush = SolidColor(Color.Unspecified),
        keyboardOptions = KeyboardOptions(capitalization = KeyboardCapitalization.None, autoCorrectEnabled = false),
        decorationBox = { inner ->
            Box(Modifier.clipToBounds().alpha(0f)) {
                Box(Modifier.atCaret(draft, control.link.start, layouts, caret)) { inner() }
            }
        },
    )
}

/**
 * Places a field whose text starts at [start] of [draft] so that its caret matches the drawn one. The field does not
 * break its lines.
 */
private fun Modifier.atCaret(draft: TextDocument, start: Int, layouts: LineLayouts, caret: () -> Rect) =
    layout { measurable, constraints ->
        val placed = measurable.measure(Constraints())
        layout(constraints.maxWidth, constraints.maxHeight) {
            val line = draft.lines.lineOf(draft.selection.caret)
            val first = draft.lines.lineOf(minOf(start, draft.text.length))
            val before = draft.lines.columnOf(draft.selection.caret) * layouts.characterWidth
            val bounds = caret()
            placed.place(
                (bounds.left - before).toInt(),
                (bounds.top - (line - first) * layouts.lineHeight).toInt(),
            )
        }
    }
