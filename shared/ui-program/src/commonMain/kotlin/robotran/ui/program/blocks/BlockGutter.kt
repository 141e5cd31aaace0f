package robotran.ui.program.blocks

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.scale
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.toggleableState
import androidx.compose.ui.state.ToggleableState
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.LayoutDirection
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import robotran.ui.code.codeColours
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlockRow

/** The line number of [row], the same as in the text. A touch sets a breakpoint, or takes it away. */
@Composable
internal fun BlockGutter(row: BlockRow, marks: RowMarks, onBreakpoint: (Int) -> Unit) {
    val line = row.line?.let { it.index + 1 }
    if (line == null) {
        Box(Modifier.width(BlockSizes.GUTTER))
        return
    }
    val words = BlockTexts.breakpoint(spoken, line)
    val colour = codeColours().breakpoint
    Box(
        Modifier
            .testTag(ProgramTags.blockLine(line))
            .size(BlockSizes.GUTTER, Dimensions.TARGET)
            .focusProperties { canFocus = false }
            .clickable(role = Role.Checkbox) { onBreakpoint(line) }
            .semantics {
                contentDescription = words
                toggleableState = ToggleableState(marks.hasBreakpoint)
            },
        Alignment.Center,
    ) {
        if (marks.isRunning) Canvas(Modifier.matchParentSize()) { drawArrow() }
        if (marks.hasBreakpoint) {
            Canvas(Modifier.size(minOf(DOT * LocalDensity.current.fontScale, BlockSizes.GUTTER))) {
                drawCircle(colour)
            }
        }
        Text(
            "$line",
            style = TextStyle(
                fontSize = NUMBER_SIZE.sp,
                fontWeight = FontWeight.Medium.takeIf { marks.hasBreakpoint || marks.isRunning },
            ),
            color = when {
                marks.hasBreakpoint -> RobotranColours.ON_COLOUR
                marks.isRunning -> RobotranColours.ON_YELLOW
                else -> LocalRobotranColours.current.quiet
            },
            maxLines = 1,
            softWrap = false,
        )
    }
}

/** An arrow from the number of the line that runs to its block. */
private fun DrawScope.drawArrow() {
    val high = ARROW_HEIGHT.toPx()
    val top = (size.height - high) / 2
    val start = ARROW_EDGE.toPx()
    val path = Path().apply {
        moveTo(start, top)
        lineTo(size.width - start - high / 2, top)
        lineTo(size.width - start, top + high / 2)
        lineTo(size.width - start - high / 2, top + high)
        lineTo(start, top + high)
        close()
    }
    if (layoutDirection == LayoutDirection.Rtl) {
        scale(-1f, 1f) { drawPath(path, RobotranColours.YELLOW) }
    } else {
        drawPath(path, RobotranColours.YELLOW)
    }
}

private val DOT = 26.dp
private val ARROW_HEIGHT = 32.dp
private val ARROW_EDGE = 3.dp
private const val NUMBER_SIZE = 13
