package robotran.ui.program.blocks.sheets

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxScope
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.robolang.outline.PhrasePart
import robotran.ui.program.blocks.BlockDragging
import robotran.ui.program.blocks.BlockScope
import robotran.workshop.blocks.BlockSheet

/**
 * The open sheet. It covers the lower part of the blocks, which do not move, and leaves the rail free.
 *
 * @param isWide whether the groups are a rail.
 * @param maxHeight the most that it may cover.
 */
@Composable
internal fun BoxScope.BlockSheetView(scope: BlockScope, dragging: BlockDragging, isWide: Boolean, maxHeight: Dp) {
    val close = { scope.show(null) }
    val below = Modifier
        .align(Alignment.BottomCenter)
        .padding(start = if (isWide) RAIL_WIDTH else 0.dp)
        .widthIn(max = MAX_WIDTH)
        .fillMaxWidth()
        .heightIn(max = maxHeight)
    when (val sheet = scope.state.sheet) {
        null -> {}

        BlockSheet.Palette -> {
            PaletteSheet(scope, dragging, isWide, close, below)
        }

        is BlockSheet.Actions -> {
            ActionsSheet(sheet.block, scope, close, below)
        }

        is BlockSheet.Note -> {
            NoteSheet(sheet.line, scope, close, below)
        }

        is BlockSheet.Line -> {
            LineSheet(sheet.line, scope, close, below)
        }

        is BlockSheet.Part -> {
            // The place of the part begins at the same offset while it is edited.
            val part = scope.state.program.partAt(sheet.span)
            if (part != null) key(sheet.span.start) { Box(below) { PartSheet(part, scope, close) } }
        }
    }
}

/** The sheet for one part of a line. */
@Composable
private fun PartSheet(part: PhrasePart, scope: BlockScope, onClose: () -> Unit) = when (part) {
    is PhrasePart.Value -> ValueSheet(part, scope, onClose)
    is PhrasePart.Choice -> ChoiceSheet(part, scope, onClose)
    is PhrasePart.NamePart -> NameSheet(part, scope, onClose)
    is PhrasePart.Text -> ShownTextSheet(part, scope, onClose)
    is PhrasePart.Word -> Unit
}

internal val RAIL_WIDTH = 84.dp
private val MAX_WIDTH = 640.dp
