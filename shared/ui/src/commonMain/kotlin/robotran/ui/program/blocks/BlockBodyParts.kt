package robotran.ui.program.blocks

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.blockediting.BlockGroup
import robotran.ui.parts.Icon
import robotran.ui.resources.Res
import robotran.ui.resources.blocks_fold
import robotran.ui.resources.blocks_unfold
import robotran.workshop.blocks.BlockRow
import robotran.workshop.event.BlockEvent

/** Six dots: here a finger carries the block at once; anywhere else it has to rest first. */
@Composable
internal fun Grip(look: BlockLook, modifier: Modifier) {
    val colour = look.ink.copy(alpha = FAINT)
    Canvas(modifier.size(GRIP_WIDTH, GRIP_HEIGHT)) {
        for (column in listOf(0.25f, 0.75f)) {
            for (line in listOf(0.15f, 0.5f, 0.85f)) {
                drawCircle(colour, DOT.toPx(), Offset(size.width * column, size.height * line))
            }
        }
    }
}

/** Hides what is inside of the block, or shows it again. */
@Composable
internal fun FoldButton(row: BlockRow.First, scope: BlockScope, look: BlockLook, modifier: Modifier) {
    val words = stringResource(if (row.isCollapsed) Res.string.blocks_unfold else Res.string.blocks_fold)
    Box(
        modifier
            .testTag("fold-${row.key}")
            .size(FOLD_WIDTH, FOLD_HEIGHT)
            .focusProperties { canFocus = false }
            .clickable(role = Role.Button) { scope.onEvent(BlockEvent.Folded(row.block.id)) }
            .semantics { contentDescription = words },
        Alignment.Center,
    ) { Sign(if (row.isCollapsed) CLOSED else OPEN, look.ink, 16.dp) }
}

@Composable
internal fun GroupSign(group: BlockGroup, look: BlockLook, modifier: Modifier) =
    Box(modifier) { Sign(GroupSigns.of(group), look.ink) }

private val OPEN = Icon.strokes("M5 9L12 16L19 9")
private val CLOSED = Icon.strokes("M9 5L16 12L9 19")
private val GRIP_WIDTH = 14.dp
private val GRIP_HEIGHT = 22.dp
private val DOT = 2.dp
private val FOLD_WIDTH = 32.dp
private val FOLD_HEIGHT = 40.dp
private const val FAINT = 0.7f
