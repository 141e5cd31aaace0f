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
import androidx.compose.ui.unit.offset
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.BlockRow

/**
 * The block of a row and, at the cursor, the button for what can be done to it. The button is beside the block, where
 * the touch that chose the block was not, so that a second touch does not open anything. Nothing moves for it: it may
 * stand on the margins of pane and block, and where not even they have room, it covers the sign.
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
        val block = parts.first().measure(loose.offset(horizontal = -BlockSizes.END.roundToPx()))
        val button = parts.getOrNull(1)?.measure(loose)
        val lastPlace = room.maxWidth - (button?.width ?: 0)
        val isBeside = lastPlace >= block.width - BlockSizes.END.roundToPx()
        val place = if (isBeside) minOf(block.width, lastPlace) else SIGN_FROM.roundToPx()
        layout(
            room.constrainWidth(maxOf(block.width, place + (button?.width ?: 0))),
            room.constrainHeight(block.height),
        ) {
            block.placeRelative(0, 0)
            button?.placeRelative(place, 0)
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

private val BUTTON = 40.dp
private val CIRCLE = 34.dp

/** With this start the circle is in the middle of the sign. */
private val SIGN_FROM = BlockSizes.GRIP - 6.dp
