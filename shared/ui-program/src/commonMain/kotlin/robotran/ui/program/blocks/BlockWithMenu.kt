package robotran.ui.program.blocks

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.layout.Layout
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.constrainHeight
import androidx.compose.ui.unit.constrainWidth
import androidx.compose.ui.unit.dp
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.BlockRow

/**
 * The block of a row and, at the cursor, the button for what can be done to it. The button is beside the block, where
 * the touch that chose the block was not, so that a second touch does not open anything. Nothing moves for it: beside a
 * block as wide as the pane it covers the sign.
 */
@Composable
internal fun BlockWithMenu(row: BlockRow, scope: BlockScope, marks: RowMarks, modifier: Modifier = Modifier) {
    val hasMenu = row.cursor != null && scope.state.cursor == row.cursor
    Layout(
        {
            BlockBody(row, scope, marks)
            if (hasMenu) MoreButton(row, scope)
        },
        modifier,
    ) { parts, room ->
        val loose = room.copy(minWidth = 0, minHeight = 0)
        val block = parts.first().measure(loose)
        val button = parts.getOrNull(1)?.measure(loose)
        val width = block.width + (button?.width ?: 0)
        val isBeside = width <= room.maxWidth
        layout(room.constrainWidth(if (isBeside) width else block.width), room.constrainHeight(block.height)) {
            block.placeRelative(0, 0)
            button?.placeRelative(if (isBeside) block.width else SIGN_FROM.roundToPx(), 0)
        }
    }
}

@Composable
private fun MoreButton(row: BlockRow, scope: BlockScope) {
    val look = if (row is BlockRow.Empty) scope.looks.empty else scope.looks.of(row.block)
    val words = BlockTexts.more(spoken)
    Box(
        Modifier
            .testTag(ProgramTags.BLOCK_MORE)
            .size(BUTTON, Dimensions.TARGET)
            .focusProperties { canFocus = false }
            .clickable(role = Role.Button) { scope.show(BlockDialog.Actions(row.block.id)) }
            .named(words),
        Alignment.Center,
    ) {
        Box(
            Modifier.size(CIRCLE).background(look.fill, CircleShape).border(2.dp, look.edge, CircleShape),
            Alignment.Center,
        ) { IconView(Icon.MORE, look.ink, size = 20.dp) }
    }
}

private val BUTTON = 44.dp
private val CIRCLE = 36.dp

/** With this start the circle is in the middle of the sign. */
private val SIGN_FROM = BlockSizes.GRIP - 8.dp
