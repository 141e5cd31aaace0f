package robotran.ui.program.editor

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.gestures.detectDragGestures
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.rememberScrollState
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.shadow
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.layout
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.dp
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*

/** The buttons for a selection by touch, above it or, at the top edge, below it. */
@Composable
internal fun SelectionBar(selection: () -> Rect, onCommand: (EditorCommand) -> Unit) {
    val colours = LocalRobotranColours.current
    Row(
        Modifier
            .beside(selection)
            .testTag(ProgramTags.SELECTION_BAR)
            .shadow(6.dp, SHAPE)
            .background(colours.pane, SHAPE)
            .border(1.dp, colours.line, SHAPE)
            .horizontalScroll(rememberScrollState()),
    ) {
        for ((command, words) in BUTTONS) {
            val tag = ProgramTags.selection(command)
            // If the text lost the focus, the bar would disappear.
            val modifier = Modifier.focusProperties {
                canFocus = false
            }
            Button(words(spoken), tag, ButtonKind.TOOL, modifier) { onCommand(command) }
        }
    }
}

/** The handle below the end of a selection, to change it by dragging. */
@Composable
internal fun SelectionHandle(place: () -> Rect, tag: String, onDrag: (Offset) -> Unit) {
    val colour = LocalRobotranColours.current.focus
    var grip by remember { mutableStateOf(Offset.Zero) }
    Box(
        Modifier
            .layout { measurable, constraints ->
                val placed = measurable.measure(constraints.copy(minWidth = 0, minHeight = 0))
                layout(0, 0) {
                    val at = place()
                    placed.place(at.left.toInt() - placed.width / 2, at.bottom.toInt())
                }
            }
            .testTag(tag)
            .size(Dimensions.TARGET)
            .clearAndSetSemantics { }
            .pointerInput(Unit) {
                detectDragGestures(
                    onDragStart = { grip = place().let { at -> Offset(at.left, (at.top + at.bottom) / 2) } },
                ) { change, amount ->
                    change.consume()
                    grip += amount
                    onDrag(grip)
                }
            },
    ) {
        Canvas(Modifier.size(Dimensions.TARGET)) {
            drawCircle(colour, 10.dp.toPx(), Offset(size.width / 2, 11.dp.toPx()))
        }
    }
}

private fun Modifier.beside(selection: () -> Rect) = layout { measurable, constraints ->
    val placed = measurable.measure(constraints.copy(minWidth = 0, minHeight = 0))
    layout(constraints.maxWidth, constraints.maxHeight) {
        val place = selection()
        val margin = 8.dp.roundToPx()
        val above = place.top.toInt() - placed.height - margin
        val below = place.bottom.toInt() + Dimensions.TARGET.roundToPx()
        val y = if (above >= 0) above else minOf(below, constraints.maxHeight - placed.height)
        val x = (place.left.toInt() - placed.width / 2).coerceIn(
            0,
            (constraints.maxWidth - placed.width).coerceAtLeast(0),
        )
        placed.place(x, y.coerceAtLeast(0))
    }
}

private val SHAPE = Shapes.SHEET
private val BUTTONS: List<Pair<EditorCommand.Plain, Label>> = listOf(
    EditorCommand.Plain.CUT to EditorTexts::cut,
    EditorCommand.Plain.COPY to EditorTexts::copy,
    EditorCommand.Plain.PASTE to EditorTexts::paste,
    EditorCommand.Plain.SELECT_ALL to EditorTexts::selectAll,
    EditorCommand.Plain.HELP to EditorTexts::help,
)
