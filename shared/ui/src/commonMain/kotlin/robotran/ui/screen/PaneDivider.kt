package robotran.ui.screen

import androidx.compose.foundation.focusable
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.gestures.draggable
import androidx.compose.foundation.gestures.rememberDraggableState
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.ProgressBarRangeInfo
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.progressBarRangeInfo
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.setProgress
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.divider
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.focusRing

/** The range of the left pane's share of the width. */
internal val SHARES = 0.2f..0.6f

/**
 * A line between two panes with a grip, moved by touch, mouse or arrow keys.
 *
 * @param share the left pane's share of [width], in pixels.
 */
@Composable
internal fun PaneDivider(share: Float, width: Float, onShare: (Float) -> Unit, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val description = stringResource(Res.string.divider)
    val now = rememberUpdatedState(share)
    val move = { change: Float -> onShare((now.value + change).coerceIn(SHARES)) }
    val drag = rememberDraggableState { move(it / width) }
    Box(
        modifier
            .testTag("divider")
            .width(24.dp)
            .fillMaxHeight()
            .focusRing(12.dp)
            .onKeyEvent { event ->
                val step = STEPS[event.key] ?: return@onKeyEvent false
                if (event.type == KeyEventType.KeyDown) move(step)
                true
            }
            .draggable(drag, Orientation.Horizontal)
            .focusable()
            .semantics {
                contentDescription = description
                progressBarRangeInfo = ProgressBarRangeInfo(now.value, SHARES)
                setProgress {
                    onShare(it.coerceIn(SHARES))
                    true
                }
            }
            .drawBehind { drawGrip(colours.line, colours.quiet) },
    )
}

private fun DrawScope.drawGrip(line: Color, grip: Color) {
    val middle = size.width / 2
    drawLine(line, Offset(middle, 0f), Offset(middle, size.height), 1.dp.toPx())
    val height = 40.dp.toPx()
    val width = 6.dp.toPx()
    drawRoundRect(
        grip,
        Offset(middle - width / 2, (size.height - height) / 2),
        Size(width, height),
        CornerRadius(width / 2),
    )
}

private val STEPS = mapOf(Key.DirectionLeft to -0.02f, Key.DirectionRight to 0.02f)
