package robotran.ui.world

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetTransform
import robotran.uikit.*
import robotran.workshop.state.SheetElement
import robotran.world.World

/** A ring around the selected element and a handle for turning it, blue on white for contrast. */
internal fun DrawScope.drawChosen(
    thing: SheetElement,
    world: World,
    session: SessionState,
    view: SheetTransform,
    colour: Color,
) {
    val pose = poseOf(thing, world, session) ?: return
    val middle = view.toPixels(pose.x, pose.y)
    val radius = view.toPixels(reachOf(thing, world)) + RING_GAP.toPx()
    drawCircle(RobotranColours.CASING, radius, middle, style = Stroke(CASING.toPx()))
    drawCircle(colour, radius, middle, style = Stroke(LINE.toPx()))
    val handle = handleOf(thing, world, session)?.let(view::toPixels) ?: return
    val way = (handle - middle) / (handle - middle).getDistance().coerceAtLeast(1f)
    drawLine(RobotranColours.CASING, middle + way * radius, handle, CASING.toPx(), StrokeCap.Round)
    drawLine(colour, middle + way * radius, handle, LINE.toPx(), StrokeCap.Round)
    drawTurnHandle(handle, way, colour)
}

/** A disc with an arrow on each side. */
internal fun DrawScope.drawTurnHandle(middle: Offset, way: Offset, colour: Color) {
    drawCircle(RobotranColours.CASING, HANDLE_RADIUS.toPx() + 2.dp.toPx(), middle)
    drawCircle(colour, HANDLE_RADIUS.toPx(), middle)
    val across = Offset(-way.y, way.x)
    val tip = HANDLE_RADIUS.toPx() * 0.65f
    val barb = tip * 0.45f
    drawLine(RobotranColours.CASING, middle - across * tip, middle + across * tip, LINE.toPx(), StrokeCap.Round)
    for (side in listOf(-1f, 1f)) {
        val end = middle + across * (tip * side)
        for (lean in listOf(-1f, 1f)) {
            drawLine(
                RobotranColours.CASING,
                end,
                end - across * (barb * side) + way * (barb * lean),
                LINE.toPx(),
                StrokeCap.Round,
            )
        }
    }
}

private val RING_GAP = 4.dp
private val CASING = 5.dp
private val LINE = 2.dp
private val HANDLE_RADIUS = 11.dp
