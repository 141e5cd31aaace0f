package robotran.ui.screen

import androidx.compose.foundation.focusable
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.gestures.detectTapGestures
import androidx.compose.foundation.gestures.draggable
import androidx.compose.foundation.gestures.rememberDraggableState
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
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
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.CustomAccessibilityAction
import androidx.compose.ui.semantics.ProgressBarRangeInfo
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.progressBarRangeInfo
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.setProgress
import androidx.compose.ui.unit.dp
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.uikit.*

/** The room that two panes share, and what both must keep. */
internal class SharedRoom(val pixels: Float, val shares: ClosedFloatingPointRange<Float>)

/**
 * A line between two panes with a grip, moved by touch, mouse, arrow keys or screen reader. A double tap, or Enter, gives
 * the panes their first sizes again.
 *
 * @param orientation the direction in which it moves.
 * @param share the program's share of [room].
 * @param onShare receives the new share, and whether that is where it stays; null for the first size.
 * @param isProgramFirst whether the program is before the divider.
 */
@Composable
internal fun PaneDivider(
    orientation: Orientation,
    share: Float,
    room: SharedRoom,
    onShare: (Float?, Boolean) -> Unit,
    modifier: Modifier = Modifier,
    isProgramFirst: Boolean = true,
) {
    val colours = LocalRobotranColours.current
    val isUpright = orientation == Orientation.Vertical
    val description = if (isUpright) ScreenTexts.dividerUpright(spoken) else ScreenTexts.divider(spoken)
    val reset = ScreenTexts.dividerReset(spoken)
    val now by rememberUpdatedState(share)
    val shares by rememberUpdatedState(room)
    val put by rememberUpdatedState(onShare)
    val sign = if (isProgramFirst) 1 else -1
    // Several movements may arrive before the next frame.
    var dragged by remember { mutableStateOf(0f) }
    val drag = rememberDraggableState {
        dragged = (dragged + sign * it / shares.pixels).coerceIn(shares.shares)
        put(dragged, false)
    }
    Box(
        modifier
            .testTag(ScreenTags.DIVIDER)
            .run { if (isUpright) fillMaxWidth().height(GRIP) else width(GRIP).fillMaxHeight() }
            .focusRing(12.dp)
            .onKeyEvent { event ->
                val step = if (isUpright) STEPS_UPRIGHT[event.key] else STEPS[event.key]
                val isReset = event.key in RESETS
                if (step == null && !isReset) return@onKeyEvent false
                if (event.type == KeyEventType.KeyDown) {
                    put(step?.let { (now + sign * it).coerceIn(shares.shares) }, true)
                }
                true
            }
            .pointerInput(Unit) { detectTapGestures(onDoubleTap = { put(null, true) }) }
            .draggable(
                drag,
                orientation,
                onDragStarted = { dragged = now },
                onDragStopped = { put(dragged, true) },
            )
            .focusable()
            .adjustedByReaders(description, reset, now.coerceIn(shares.shares), shares.shares) { put(it, true) }
            .drawBehind { drawGrip(isUpright, colours.line, colours.quiet) },
    )
}

private fun Modifier.adjustedByReaders(
    description: String,
    reset: String,
    share: Float,
    shares: ClosedFloatingPointRange<Float>,
    onShare: (Float?) -> Unit,
) = semantics {
    contentDescription = description
    progressBarRangeInfo = ProgressBarRangeInfo(share, shares)
    setProgress {
        onShare(it.coerceIn(shares))
        true
    }
    customActions = listOf(
        CustomAccessibilityAction(reset) {
            onShare(null)
            true
        },
    )
}

private fun DrawScope.drawGrip(isUpright: Boolean, line: Color, grip: Color) {
    val long = 40.dp.toPx()
    val thick = 6.dp.toPx()
    val end = if (isUpright) Offset(size.width, center.y) else Offset(center.x, size.height)
    drawLine(line, if (isUpright) Offset(0f, center.y) else Offset(center.x, 0f), end, 1.dp.toPx())
    val shape = if (isUpright) Size(long, thick) else Size(thick, long)
    drawRoundRect(grip, center - Offset(shape.width, shape.height) / 2f, shape, CornerRadius(thick / 2))
}

internal val GRIP = 24.dp
private val STEPS = mapOf(Key.DirectionLeft to -0.02f, Key.DirectionRight to 0.02f)
private val STEPS_UPRIGHT = mapOf(Key.DirectionUp to -0.02f, Key.DirectionDown to 0.02f)
private val RESETS = setOf(Key.Enter, Key.NumPadEnter)
