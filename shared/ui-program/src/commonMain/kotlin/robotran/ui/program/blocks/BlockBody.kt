package robotran.ui.program.blocks

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.FlowRowScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.graphicsLayer
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.FontStyle
import androidx.compose.ui.unit.dp
import robotran.blockediting.Block
import robotran.ui.code.BlockLook
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlockRow

/** The coloured block of a row. A touch puts the cursor there. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun BlockBody(row: BlockRow, scope: BlockScope, marks: RowMarks) {
    val look = if (row is BlockRow.Empty) scope.looks.empty else scope.looks.of(row.block)
    val shape = BlockShape.of(row)
    val outline = outlineOf(row, look, scope, marks)
    val fill = when {
        row.isSeeThrough -> Color.Transparent
        marks.isRunning -> LocalRobotranColours.current.runningLine
        else -> look.fill
    }
    val dragging = LocalBlockDragging.current
    val inked = if (marks.isRunning) look.copy(ink = LocalRobotranColours.current.onPane) else look
    Row(
        Modifier
            .testTag(ProgramTags.block(row.key))
            .graphicsLayer { alpha = if (marks.isCarried) CARRIED else 1f }
            .drawBehind { drawBlock(shape, fill, look.edge, outline) }
            .clip(RoundedCornerShape(BlockSizes.CORNER))
            .defaultMinSize(minWidth = MIN_WIDTH, minHeight = Dimensions.TARGET)
            .focusProperties { canFocus = false }
            .spokenAs(row, scope, marks)
            .clickable { scope.touched(row, dragging?.isShiftHeld == true) }
            .padding(end = 8.dp, top = 4.dp, bottom = 4.dp),
    ) {
        BlockLead(row, scope, inked)
        FlowRow(
            Modifier.weight(1f, fill = false),
            Arrangement.spacedBy(6.dp),
            Arrangement.spacedBy(4.dp, Alignment.CenterVertically),
        ) {
            when (row) {
                is BlockRow.First -> FirstLine(row, scope, inked)
                is BlockRow.Branch -> LineParts(row.line, scope, inked)
                is BlockRow.End -> BlockWords(
                    row.line?.let(scope::wordsOf) ?: scope.shown("end"),
                    scope,
                    inked,
                    onLine(),
                )
                is BlockRow.Empty -> BlockWords(BlockTexts.empty(spoken), scope, inked, onLine())
            }
            if (row !is BlockRow.First) row.line?.comment?.let { NoteTag(scope.textOf(it), scope, onLine()) }
        }
        if (row is BlockRow.First && row.block is Block.Construct) FoldButton(row, scope, inked)
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun FlowRowScope.FirstLine(row: BlockRow.First, scope: BlockScope, look: BlockLook) {
    val block = row.block
    when (block) {
        is Block.Blank -> Unit
        is Block.Comment -> Note(scope.textOf(block.head.span), scope, look, onLine())
        is Block.Loose -> BlockWords(scope.wordsOf(block.head), scope, look, onLine())

        is Block.Command, is Block.Construct -> if (block.head.form == null) {
            BlockWords(scope.wordsOf(block.head), scope, look, onLine())
        } else {
            LineParts(block.head, scope, look)
        }
    }
    if (block !is Block.Comment) block.head.comment?.let { NoteTag(scope.textOf(it), scope, onLine()) }
    if (block is Block.Construct && row.isCollapsed) Folded(block, scope, look, onLine())
}

/** A comment at the end of a line, as a slip of paper on the block. */
@Composable
private fun NoteTag(comment: String, scope: BlockScope, modifier: Modifier) {
    val look = scope.looks.note
    Note(
        comment,
        scope,
        look,
        modifier
            .background(look.fill, RoundedCornerShape(NOTE_CORNER))
            .border(1.dp, look.edge, RoundedCornerShape(NOTE_CORNER))
            .padding(horizontal = 8.dp, vertical = 4.dp),
    )
}

/** A comment, without `//`. */
@Composable
private fun Note(comment: String, scope: BlockScope, look: BlockLook, modifier: Modifier) = Text(
    comment.trim().removePrefix("//").trim(),
    modifier.clearAndSetSemantics { },
    TextStyle(fontStyle = FontStyle.Italic, fontSize = scope.wordSize),
    color = look.ink,
)

/** An empty line and the room in a block show the pane. */
private val BlockRow.isSeeThrough: Boolean get() = this is BlockRow.Empty || block is Block.Blank

@Composable
private fun outlineOf(row: BlockRow, look: BlockLook, scope: BlockScope, marks: RowMarks): BlockOutline? {
    val colours = LocalRobotranColours.current
    val isSelected = row.block.id in scope.state.selected && row !is BlockRow.Empty
    val isAt = row.cursor != null && row.cursor == scope.state.cursor
    return when {
        marks.isCarried -> BlockOutline(colours.onPane, 2.dp, isDashed = true)
        isSelected || isAt -> BlockOutline(colours.focus, RING, halo = colours.pane)
        marks.isFoundNow -> BlockOutline(colours.onPane, RING, halo = RobotranColours.YELLOW)
        marks.isRunning -> BlockOutline(RobotranColours.YELLOW, RING, halo = colours.onPane)
        marks.isFound -> BlockOutline(RobotranColours.YELLOW, RING)
        row.block is Block.Loose -> BlockOutline(look.edge, 2.dp, isDashed = true)
        row is BlockRow.Empty -> BlockOutline(look.edge, 1.dp, isDashed = true)
        row.block is Block.Blank -> null
        marks.hasError -> BlockOutline(colours.error, 2.dp, isDashed = true)
        look.edge != look.fill -> BlockOutline(look.edge, 2.dp)
        else -> null
    }
}

private val MIN_WIDTH = 120.dp
private val RING = 3.dp
private val NOTE_CORNER = Corners.PIECE
private const val CARRIED = 0.4f
