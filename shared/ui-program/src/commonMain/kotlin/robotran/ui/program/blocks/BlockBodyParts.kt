package robotran.ui.program.blocks

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.dp
import robotran.blockediting.Block
import robotran.ui.code.BlockLook
import robotran.ui.code.BlockSigns
import robotran.ui.code.GroupSigns
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlockRow
import robotran.workshop.blocks.group
import robotran.workshop.event.BlockEvent

/** What stands before the words of a row: the grip, and the sign of the line. */
@Composable
internal fun BlockLead(row: BlockRow, scope: BlockScope, look: BlockLook) {
    if (row is BlockRow.Empty) {
        Box(Modifier.width(EMPTY_LEAD))
        return
    }
    Row(Modifier.padding(end = AFTER_SIGN), verticalAlignment = Alignment.CenterVertically) {
        Box(Modifier.size(BlockSizes.GRIP, HEIGHT), Alignment.Center) { if (row is BlockRow.First) Grip(look) }
        Box(Modifier.size(SLOT_WIDTH, HEIGHT), Alignment.Center) {
            if (row is BlockRow.First) signOf(row.block, scope)?.let { IconView(it, look.ink, size = 20.dp) }
        }
    }
}

private fun signOf(block: Block, scope: BlockScope): Icon? = when (block) {
    is Block.Blank -> null

    is Block.Comment -> GroupSigns.NOTE

    is Block.Loose -> GroupSigns.MISTAKE

    is Block.Command, is Block.Construct ->
        block.head.form?.let { BlockSigns.of(it, scope.inEnglish(scope.sourceOf(block.head))) }
            ?: block.group?.let { GroupSigns.of(it) }
            ?: GroupSigns.MISTAKE
}

/** Six dots: here a finger carries the block at once; anywhere else it has to rest first. */
@Composable
private fun Grip(look: BlockLook) {
    val colour = look.ink.copy(alpha = FAINT)
    Canvas(Modifier.size(GRIP_WIDTH, GRIP_HEIGHT)) {
        for (column in listOf(0.2f, 0.8f)) {
            for (line in listOf(0.12f, 0.5f, 0.88f)) {
                drawCircle(colour, DOT.toPx(), Offset(size.width * column, size.height * line))
            }
        }
    }
}

/** Hides what is inside of the block, or shows it again. */
@Composable
internal fun FoldButton(row: BlockRow.First, scope: BlockScope, look: BlockLook) {
    val words = if (row.isCollapsed) BlockTexts.unfold(spoken) else BlockTexts.fold(spoken)
    Box(
        Modifier
            .testTag(ProgramTags.fold(row.key))
            .size(FOLD_WIDTH, HEIGHT)
            .clip(CircleShape)
            .focusProperties { canFocus = false }
            .clickable(role = Role.Button) { scope.onEvent(BlockEvent.Folded(row.block.id)) }
            .named(words),
        Alignment.Center,
    ) { IconView(if (row.isCollapsed) CLOSED else OPEN, look.ink, size = 20.dp) }
}

/** How much a folded block hides. */
@Composable
internal fun Folded(block: Block.Construct, scope: BlockScope, look: BlockLook, modifier: Modifier) {
    val count = block.slots.sumOf { it.blocks.size }
    BlockWords(
        scope.messages.inside(count),
        scope,
        look.copy(ink = look.socketInk),
        modifier
            .background(look.tint, RoundedCornerShape(FOLDED_CORNER))
            .border(1.dp, look.edge, RoundedCornerShape(FOLDED_CORNER))
            .padding(horizontal = 10.dp, vertical = 6.dp),
    )
}

private val OPEN = Icon.strokes("M5 9L12 16L19 9")
private val CLOSED = Icon.strokes("M9 5L16 12L9 19")

/** The height of one line of a block without its margins. */
private val HEIGHT = lineHeight()
private val SLOT_WIDTH = 28.dp
private val AFTER_SIGN = 4.dp
private val FOLD_WIDTH = 32.dp
private val EMPTY_LEAD = 16.dp
private val GRIP_WIDTH = 12.dp
private val GRIP_HEIGHT = 20.dp
private val DOT = 2.dp
private val FOLDED_CORNER = Corners.SMALL
private const val FAINT = 0.7f
