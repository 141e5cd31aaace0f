package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxScope
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.key
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.robolang.outline.PhrasePart
import robotran.ui.program.blocks.BlockDragging
import robotran.ui.program.blocks.BlockScope
import robotran.workshop.blocks.BlockDialog

/**
 * The open sheet. It covers the lower part of the blocks or, in a low pane, stands beside them. They do not move, and the
 * groups stay free. In a very low pane it covers all.
 */
@Composable
internal fun BoxScope.BlockDialogView(scope: BlockScope, dragging: BlockDragging, room: BlocksRoom) {
    val close = { scope.show(null) }
    val below = Modifier
        .align(if (room.dialogs == SheetPlace.BESIDE) Alignment.BottomEnd else Alignment.BottomCenter)
        .padding(start = if (room.hasGroups) room.railWidth else 0.dp)
        .widthIn(max = room.sheetWidth)
        .fillMaxWidth()
        .heightIn(max = room.heightOf(scope.state.sheet))
    CompositionLocalProvider(LocalSheetPlace provides room.dialogs) { OpenDialog(scope, dragging, room, close, below) }
}

@Composable
private fun OpenDialog(
    scope: BlockScope,
    dragging: BlockDragging,
    room: BlocksRoom,
    close: () -> Unit,
    below: Modifier,
) {
    when (val sheet = scope.state.sheet) {
        null -> {}
        BlockDialog.Palette -> PaletteDialog(scope, dragging, room, close, below)
        is BlockDialog.Actions -> ActionsDialog(sheet.block, scope, close, below)
        is BlockDialog.Note -> NoteDialog(sheet.line, scope, close, below)
        is BlockDialog.Line -> LineDialog(sheet.line, scope, close, below)

        is BlockDialog.Part -> {
            // The place of the part begins at the same offset while it is edited.
            val part = scope.state.program.partAt(sheet.span)
            if (part != null) key(sheet.span.start) { Box(below) { PartDialog(part, scope, close) } }
        }
    }
}

/** The sheet for one part of a line. */
@Composable
private fun PartDialog(part: PhrasePart, scope: BlockScope, onClose: () -> Unit) = when (part) {
    is PhrasePart.Value -> ValueDialog(part, scope, onClose)
    is PhrasePart.Choice -> ChoiceDialog(part, scope, onClose)
    is PhrasePart.NamePart -> NameDialog(part, scope, onClose)
    is PhrasePart.Text -> ShownTextDialog(part, scope, onClose)
    is PhrasePart.Word -> Unit
}
