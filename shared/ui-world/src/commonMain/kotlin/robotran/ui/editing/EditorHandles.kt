package robotran.ui.editing

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.sheet.addLine
import robotran.uikit.*

/** A handle at its position in pixels of the canvas. */
internal class HandleAt<H>(val handle: H, val at: Offset)

/** The nearest handle within [reach] of [position]; [handicap] is what the distance of one is greater by. */
internal fun <H> List<HandleAt<H>>.nearest(position: Offset, reach: Float, handicap: (H) -> Float = { 0f }): H? =
    filter { (it.at - position).getDistance() <= reach }
        .minByOrNull { (it.at - position).getDistance() + handicap(it.handle) }?.handle

/** The line around what is chosen. */
internal fun DrawScope.drawChosenFrame(corners: List<Offset>, width: Dp, casing: Dp) {
    val path = Path().apply { addLine(corners, closed = true) }
    drawPath(path, RobotranColours.CASING, style = Stroke(casing.toPx()))
    drawPath(path, EditingColours.ACCENT, style = Stroke(width.toPx()))
}

/** A handle; a round one turns or is a corner. */
internal fun DrawScope.drawKnob(position: Offset, isRound: Boolean, size: Dp) {
    val radius = size.toPx()
    val line = Stroke(2.dp.toPx())
    if (isRound) {
        drawCircle(RobotranColours.CASING, radius, position)
        drawCircle(EditingColours.ACCENT, radius, position, style = line)
    } else {
        val corner = position - Offset(radius, radius)
        drawRect(RobotranColours.CASING, corner, Size(radius * 2, radius * 2))
        drawRect(EditingColours.ACCENT, corner, Size(radius * 2, radius * 2), style = line)
    }
}
