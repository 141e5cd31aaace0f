package robotran.ui.program.blocks

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.Immutable
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.unit.LayoutDirection
import robotran.blockediting.Block
import robotran.language.source.Diagnostic
import robotran.ui.program.editor.LineNote
import robotran.uikit.*
import robotran.workshop.blocks.BlockRow
import robotran.workshop.state.InlineDiagnostic

/**
 * What else is known about a row.
 *
 * @property hasBreakpoint whether the program stops before its line.
 * @property isRunning whether its line runs now.
 * @property notes the mistakes and doubts at its line.
 * @property isCarried whether a finger carries its block.
 * @property isFound whether the search has found something in its line.
 * @property isFoundNow whether that is the match that is selected.
 */
@Immutable
internal data class RowMarks(
    val hasBreakpoint: Boolean = false,
    val isRunning: Boolean = false,
    val notes: List<InlineDiagnostic> = emptyList(),
    val isCarried: Boolean = false,
    val isFound: Boolean = false,
    val isFoundNow: Boolean = false,
) {
    val hasError: Boolean get() = notes.any { !it.isWarning }
}

/**
 * A row of blocks: the line number, the bars of the blocks around it, the block itself, and the notes on mistakes.
 *
 * @param lineOfFix the text of the line that the fix of a note would change.
 */
@Composable
internal fun BlockRowView(
    row: BlockRow,
    scope: BlockScope,
    marks: RowMarks,
    onBreakpoint: (Int) -> Unit,
    lineOfFix: (InlineDiagnostic) -> String,
    onFix: (Diagnostic) -> Unit,
    modifier: Modifier = Modifier,
) {
    val bars = row.around.map { scope.looks.of(it).edge }
    val own = ownBar(row, scope)
    Column(
        modifier.fillMaxWidth().drawBehind {
            bars.forEachIndexed { index, colour -> drawBar(colour, index, 0f, size.height) }
            if (own != null) drawBar(own.first, bars.size, own.second * size.height, own.third * size.height)
        },
    ) {
        Row(Modifier.padding(top = BlockSizes.GAP)) {
            BlockGutter(row, marks, onBreakpoint)
            BlockWithMenu(row, scope, marks, Modifier.padding(start = BlockSizes.INDENT * row.around.size))
        }
        for (note in marks.notes) {
            Row {
                Box(Modifier.width(BlockSizes.GUTTER + BlockSizes.INDENT * (row.around.size + 1)))
                LineNote(note, lineOfFix(note), standsOut = false, onFix)
            }
        }
    }
}

/** The bar that joins the lines of one block: its colour, and from where to where in the row. */
private fun ownBar(row: BlockRow, scope: BlockScope): Triple<Color, Float, Float>? {
    val edge = scope.looks.of(row.block).edge
    return when (row) {
        is BlockRow.First -> Triple(edge, HALF, 1f).takeIf { row.block is Block.Construct && !row.isCollapsed }
        is BlockRow.Branch -> Triple(edge, 0f, 1f)
        is BlockRow.End -> Triple(edge, 0f, HALF)
        is BlockRow.Empty -> null
    }
}

private fun DrawScope.drawBar(colour: Color, depth: Int, top: Float, bottom: Float) {
    val start = (BlockSizes.GUTTER + BlockSizes.INDENT * depth).toPx()
    val width = BlockSizes.BAR.toPx()
    val x = if (layoutDirection == LayoutDirection.Rtl) size.width - start - width else start
    drawRect(colour, Offset(x, top), Size(width, bottom - top))
}

private const val HALF = 0.5f
