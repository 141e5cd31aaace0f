package robotran.uikit

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxScope
import androidx.compose.foundation.layout.Spacer
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.mutableStateListOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.layout.LayoutCoordinates
import androidx.compose.ui.layout.onPlaced
import androidx.compose.ui.platform.LocalInputModeManager
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** The rings of one window, dialog or menu, which are drawn over all that is in it. */
internal class FocusRings {
    private val focused = mutableStateListOf<FocusRingNode>()
    private var movements by mutableIntStateOf(0)

    /** The place of the window that the rings are drawn in. */
    var window: LayoutCoordinates? = null

    fun add(node: FocusRingNode) {
        focused += node
    }

    fun remove(node: FocusRingNode) {
        focused -= node
    }

    fun moved() {
        movements++
    }

    fun draw(scope: DrawScope, colour: Color) = with(scope) {
        // Read so that a ring follows its element.
        movements
        val window = window?.takeIf { it.isAttached } ?: return@with
        for (node in focused) {
            val coordinates = node.coordinates?.takeIf { it.isAttached } ?: continue
            // Of an element that is scrolled half out of sight, the part that can be seen.
            val seen = window.localBoundingBoxOf(coordinates)
            if (!seen.isEmpty) drawRing(seen, colour, node.cornerRadius, if (node.isInside) INSIDE else 0.dp)
        }
    }
}

internal val LocalFocusRings = staticCompositionLocalOf<FocusRings?> { null }

/**
 * [content] as all that is in one window, dialog or menu: input there is noted, and focused elements have rings.
 */
@Composable
internal fun FocusWindow(modifier: Modifier = Modifier, content: @Composable BoxScope.() -> Unit) {
    val rings = remember { FocusRings() }
    val colour = LocalRobotranColours.current.focus
    val input = LocalInputModeManager.current
    Box(modifier.tellsInputMode(), propagateMinConstraints = true) {
        CompositionLocalProvider(LocalFocusRings provides rings) { content() }
        Spacer(
            Modifier
                .matchParentSize()
                .onPlaced { rings.window = it }
                .drawBehind { if (input.areKeysInUse) rings.draw(this, colour) },
        )
    }
}

/** A ring around [element], blue on white for contrast with paper, desk and brick. At an edge it moves inwards. */
private fun DrawScope.drawRing(element: Rect, colour: Color, cornerRadius: Dp, inset: Dp) {
    val outer = OUTER - inset
    val shown = Rect(Offset.Zero, size).deflate(OUTER.toPx())
    val bounds = if (inset > 0.dp) element else element.intersect(shown)
    ring(bounds, Color.White, outer - 3.5.dp, 2.dp, cornerRadius)
    ring(bounds, colour, outer - 1.5.dp, 3.dp, cornerRadius)
}

private fun DrawScope.ring(element: Rect, colour: Color, outset: Dp, width: Dp, cornerRadius: Dp) {
    val out = outset.toPx()
    drawRoundRect(
        color = colour,
        topLeft = Offset(element.left - out, element.top - out),
        size = Size(element.width + 2 * out, element.height + 2 * out),
        cornerRadius = CornerRadius((cornerRadius.toPx() + out).coerceAtLeast(0f)),
        style = Stroke(width.toPx()),
    )
}

/** From the element to the ring's outer edge. */
private val OUTER = 4.5.dp

/** Moves the ring within the bounds. */
private val INSIDE = 5.dp
