package robotran.uikit

import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.gestures.ScrollableState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawWithContent
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Brush
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.unit.dp

/**
 * Shows that there is more to scroll: the content of [scroll] fades into its [ground] at that edge, with an [arrow] in
 * this colour. Must precede the scroll modifier.
 */
@Composable
fun Modifier.scrollHint(
    scroll: ScrollableState,
    orientation: Orientation = Orientation.Vertical,
    ground: Color = LocalRobotranColours.current.pane,
    arrow: Color = LocalRobotranColours.current.onPane,
): Modifier = drawWithContent {
    drawContent()
    if (scroll.canScrollBackward) drawHint(orientation, isForward = false, ground, arrow)
    if (scroll.canScrollForward) drawHint(orientation, isForward = true, ground, arrow)
}

private fun DrawScope.drawHint(orientation: Orientation, isForward: Boolean, ground: Color, arrow: Color) {
    val isVertical = orientation == Orientation.Vertical
    val along = if (isVertical) size.height else size.width
    val middle = (if (isVertical) size.width else size.height) / 2
    val depth = minOf(SCROLL_HINT_DEPTH.toPx(), along / 3)
    val edge = if (isForward) along else 0f
    val inner = if (isForward) along - depth else depth
    val fade = arrayOf(0f to ground.copy(alpha = 0f), SOLID to ground.copy(alpha = 0.95f), 1f to ground)
    if (isVertical) {
        drawRect(
            Brush.verticalGradient(*fade, startY = inner, endY = edge),
            Offset(0f, minOf(inner, edge)),
            Size(size.width, depth),
        )
    } else {
        drawRect(
            Brush.horizontalGradient(*fade, startX = inner, endX = edge),
            Offset(minOf(inner, edge), 0f),
            Size(depth, size.height),
        )
    }
    val outward = if (isForward) 1f else -1f
    val tip = edge - outward * TIP.toPx()
    val wings = tip - outward * ARROW_DEPTH.toPx()
    val half = ARROW_DEPTH.toPx() * 2

    fun at(place: Float, across: Float) = if (isVertical) Offset(across, place) else Offset(place, across)
    for (side in listOf(
        -half,
        half,
    )) {
        drawLine(arrow, at(tip, middle), at(wings, middle + side), ARROW_WIDTH.toPx(), StrokeCap.Round)
    }
}

/** The depth of the hint at the edge; visible elements must be scrolled beyond it. */
val SCROLL_HINT_DEPTH = 32.dp

/** From this part of the fade on, the content below is hardly visible. */
private const val SOLID = 0.6f
private val TIP = 3.dp
private val ARROW_DEPTH = 4.dp
private val ARROW_WIDTH = 2.dp
