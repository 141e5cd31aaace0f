package robotran.ui.program.blocks

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.FlowRowScope
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.alpha
import androidx.compose.ui.draw.clip
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Shape
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.font.FontStyle
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.blockediting.Block
import robotran.ui.resources.Res
import robotran.ui.resources.blocks_empty
import robotran.ui.resources.blocks_runs
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.RobotranColours
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockRow
import robotran.workshop.blocks.group
import robotran.workshop.event.BlockEvent

/** The coloured block of a row. A touch puts the cursor there. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun BlockBody(row: BlockRow, scope: BlockScope, marks: RowMarks) {
    val look = if (row is BlockRow.Empty) scope.looks.note else scope.looks.of(row.block)
    val isSelected = row.block.id in scope.state.selected && row !is BlockRow.Empty
    val isAt = row.cursor != null && row.cursor == scope.state.cursor
    val shape = shapeOf(row)
    val runs = stringResource(Res.string.blocks_runs)
    val line = outlineOf(look, isSelected || isAt, marks.isRunning)
    FlowRow(
        Modifier
            .testTag("block-${row.key}")
            .alpha(if (marks.isCarried) CARRIED else 1f)
            .defaultMinSize(minWidth = MIN_WIDTH, minHeight = Dimensions.TARGET)
            .clip(shape)
            .background(if (marks.isRunning) LocalRobotranColours.current.runningLine else look.fill)
            .border(line.first, line.second, shape)
            .focusProperties { canFocus = false }
            .clickable { scope.onEvent(BlockEvent.CursorPut(row.cursor ?: BlockCursor.At(row.block.id))) }
            .spokenAs(row, scope)
            .semantics { if (marks.isRunning) stateDescription = runs }
            .padding(start = 6.dp, end = 10.dp, top = 4.dp, bottom = 4.dp),
        Arrangement.spacedBy(6.dp),
        Arrangement.spacedBy(4.dp, Alignment.CenterVertically),
    ) {
        val inked = if (marks.isRunning) look.copy(ink = LocalRobotranColours.current.onPane) else look
        when (row) {
            is BlockRow.First -> FirstLine(row, scope, inked)
            is BlockRow.Branch -> LineParts(row.line, scope, inked)
            is BlockRow.End -> BlockWords(row.line?.let(scope::wordsOf) ?: "end", scope, inked, middle())
            is BlockRow.Empty -> BlockWords(stringResource(Res.string.blocks_empty), scope, inked, middle())
        }
        if (row !is BlockRow.First) row.line?.comment?.let { Note(scope.textOf(it), scope, inked, middle()) }
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun FlowRowScope.FirstLine(row: BlockRow.First, scope: BlockScope, look: BlockLook) {
    val block = row.block
    Grip(look, middle())
    if (block is Block.Construct) FoldButton(row, scope, look, middle())
    block.group?.let { GroupSign(it, look, middle()) }
    when (block) {
        is Block.Blank -> Unit

        is Block.Comment -> Note(scope.textOf(block.head.span).trim(), scope, look, middle())

        is Block.Loose -> BlockWords(scope.wordsOf(block.head), scope, look, middle())

        is Block.Command, is Block.Construct -> if (block.head.form == null) {
            BlockWords(scope.wordsOf(block.head), scope, look, middle())
        } else {
            LineParts(block.head, scope, look)
        }
    }
    if (block !is Block.Comment) block.head.comment?.let { Note(scope.textOf(it), scope, look, middle()) }
    if (row.isCollapsed) BlockWords("…", scope, look, middle())
}

/** A comment, without `//`. */
@Composable
private fun Note(comment: String, scope: BlockScope, look: BlockLook, modifier: Modifier) = Text(
    comment.removePrefix("//").trim(),
    modifier.clearAndSetSemantics { },
    color = look.ink,
    fontSize = scope.wordSize,
    fontStyle = FontStyle.Italic,
)

@OptIn(ExperimentalLayoutApi::class)
private fun FlowRowScope.middle(): Modifier = Modifier.align(Alignment.CenterVertically)

/** The corner from which the bar beside the inside goes down is square, and so is the one in which it ends. */
private fun shapeOf(row: BlockRow): Shape {
    val round = BlockSizes.CORNER
    return when (row) {
        is BlockRow.First -> {
            val isOpen = row.block is Block.Construct && !row.isCollapsed
            RoundedCornerShape(round, round, round, if (isOpen) 0.dp else round)
        }

        is BlockRow.Branch -> {
            RoundedCornerShape(0.dp, round, round, 0.dp)
        }

        is BlockRow.End -> {
            RoundedCornerShape(0.dp, round, round, round)
        }

        is BlockRow.Empty -> {
            RoundedCornerShape(round)
        }
    }
}

@Composable
private fun outlineOf(look: BlockLook, isSelected: Boolean, isRunning: Boolean): Pair<Dp, Color> = when {
    isSelected -> 3.dp to LocalRobotranColours.current.focus
    isRunning -> 3.dp to RobotranColours.YELLOW
    else -> 2.dp to look.edge
}

private val MIN_WIDTH = 72.dp
private const val CARRIED = 0.4f
