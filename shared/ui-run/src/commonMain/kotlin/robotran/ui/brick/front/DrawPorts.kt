package robotran.ui.brick.front

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.lerp
import robotran.uikit.*

/** A two by two plate with four contact studs, like the plug of a cable; fills the draw area. */
internal fun DrawScope.drawStuds(form: PortForm.Studs, colour: Color, planUnit: Float) {
    val unit = size.width / PORT_UNITS
    drawRoundRect(form.edge, cornerRadius = CornerRadius(STUDS_CORNER * planUnit))
    val edge = lerp(colour, RobotranColours.SHADE, 0.35f)
    drawRoundRect(
        colour,
        Offset(unit, unit),
        Size(size.width - 2 * unit, size.height - 2.5f * unit),
        CornerRadius(6 * unit),
    )
    for (x in STUD_PLACES) {
        for (y in STUD_PLACES) {
            val middle = Offset(x * unit, y * unit)
            drawCircle(lerp(colour, RobotranColours.ON_COLOUR, 0.18f), 7 * unit, middle, alpha = 0.25f)
            drawCircle(edge, 7 * unit, middle, alpha = 0.3f, style = Stroke(unit))
        }
    }
}

/** A plug with its cable; an empty socket is only its hole. Fills the draw area. */
internal fun DrawScope.drawPlug(form: PortForm.Plug, colour: Color, isPlugged: Boolean, unit: Float) {
    val block = form.side.within(Rect(Offset.Zero, size), CABLE_LENGTH * unit)
    val corner = CornerRadius(PLUG_CORNER * unit)
    if (!isPlugged) {
        drawRoundRect(form.holeEdge, block.topLeft, block.size, corner)
        val hole = block.deflate(unit * 1.5f)
        drawRoundRect(form.hole, hole.topLeft, hole.size, corner)
        return
    }
    val width = CABLE_WIDTH * unit
    val cable = form.side.atEdge(Rect(Offset.Zero, size), width, CABLE_LENGTH * unit + unit)
    drawRect(form.edge, cable.topLeft, cable.size)
    drawRoundRect(form.edge, block.topLeft, block.size, corner)
    val face = block.deflate(unit)
    drawRoundRect(colour, face.topLeft, face.size, corner)
    val latch = form.side.atEdge(block, width * LATCH_WIDTH, unit * LATCH_HEIGHT)
    drawRect(form.latch, latch.topLeft, latch.size)
}

/** [whole] without [depth] on this side. */
private fun FrontSide.within(whole: Rect, depth: Float) = when (this) {
    FrontSide.ABOVE -> Rect(whole.left, whole.top + depth, whole.right, whole.bottom)
    FrontSide.BELOW -> Rect(whole.left, whole.top, whole.right, whole.bottom - depth)
    FrontSide.LEFT -> Rect(whole.left + depth, whole.top, whole.right, whole.bottom)
    FrontSide.RIGHT -> Rect(whole.left, whole.top, whole.right - depth, whole.bottom)
}

/** What lies in [whole] along the middle of this side, so wide and so deep. */
private fun FrontSide.atEdge(whole: Rect, width: Float, depth: Float): Rect {
    val half = if (x == 0f) Offset(width / 2, depth / 2) else Offset(depth / 2, width / 2)
    val middle = whole.center + Offset(x * (whole.width / 2 - half.x), y * (whole.height / 2 - half.y))
    return Rect(middle - half, middle + half)
}

/** A triangle that points up for forward and down for backward; fills the draw area. */
internal fun DrawScope.drawDirectionArrow(forward: Boolean, colour: Color) {
    val tip = if (forward) 0f else size.height
    val base = size.height - tip
    drawPath(polygon(size.width / 2, tip, size.width, base, 0f, base), colour)
}

private const val PORT_UNITS = 54f
private val STUD_PLACES = listOf(13f, 41f)
private const val STUDS_CORNER = 7f

/** The visible end of a cable, in units. */
internal const val CABLE_LENGTH = 7f
private const val CABLE_WIDTH = 22f
private const val PLUG_CORNER = 7f
private const val LATCH_WIDTH = 1.2f
private const val LATCH_HEIGHT = 4f
