package robotran.ui.brick.plug

import androidx.compose.ui.geometry.Rect
import robotran.ui.brick.front.FrontPlan
import robotran.ui.brick.front.FrontSide
import robotran.ui.brick.front.PortForm
import robotran.ui.brick.front.PortLook
import robotran.ui.brick.nxt.NxtColours

/** [count] plugs in a row from left to right, as wide as they can be. */
internal fun rowOf(count: Int, side: FrontSide, widest: Float): List<Rect> {
    val width = minOf(widest, (FrontPlan.WIDTH - SPACE) / count - SPACE)
    val first = (FrontPlan.WIDTH - count * (width + SPACE) + SPACE) / 2
    val top = if (side == FrontSide.ABOVE) 0f else FrontPlan.HEIGHT - PORT_HEIGHT
    return List(count) {
        val left = first + it * (width + SPACE)
        Rect(left, top, left + width, top + PORT_HEIGHT)
    }
}

/** A plug as an NXT has it, at [side] of the brick. */
internal fun portLook(side: FrontSide) = PortLook(
    PortForm.Plug(
        side,
        NxtColours.PLUG_EDGE,
        latch = NxtColours.LABEL.copy(alpha = 0.28f),
        holeEdge = NxtColours.EDGE,
        hole = NxtColours.SOCKET,
    ),
    NxtColours.PLUG,
    NxtColours.DRIVEN,
    ink = NxtColours.ON_PLUG,
    litInk = NxtColours.LABEL,
)

private const val PORT_HEIGHT = 63f
private const val SPACE = 7f
