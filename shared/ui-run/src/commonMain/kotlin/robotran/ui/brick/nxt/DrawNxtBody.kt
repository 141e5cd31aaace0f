package robotran.ui.brick.nxt

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.RoundRect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipPath
import androidx.compose.ui.graphics.drawscope.withTransform
import robotran.uikit.*

/**
 * The grey case: beams with holes at the sides, the light face with the frame of the display, the loudspeaker and a
 * lamp.
 *
 * @param isSending whether it sends by radio.
 */
internal fun DrawScope.drawNxtBody(isSounding: Boolean, isSending: Boolean) {
    val unit = size.width / NxtPlan.WIDTH
    withTransform({ scale(unit, unit, Offset.Zero) }) {
        val body = NxtPlan.BODY
        block(body, NxtColours.EDGE, NxtPlan.CORNER)
        block(body.deflate(1.5f).translate(0f, -1f), NxtColours.BEAM, NxtPlan.CORNER)
        clipPath(Path().apply { addRoundRect(RoundRect(body.deflate(1.5f), CornerRadius(NxtPlan.CORNER))) }) {
            drawRect(NxtColours.FACE, NxtPlan.FACE.topLeft, NxtPlan.FACE.size)
            for (x in listOf(NxtPlan.FACE.left, NxtPlan.FACE.right)) {
                drawLine(NxtColours.FACE_EDGE, Offset(x, body.top), Offset(x, body.bottom), 1.5f)
            }
        }
        for (x in NxtPlan.BEAMS) {
            for (y in NxtPlan.BEAM_HOLES) {
                drawCircle(NxtColours.BEAM_HOLE, NxtPlan.HOLE_RADIUS, Offset(x, y))
                drawCircle(NxtColours.EDGE, NxtPlan.HOLE_RADIUS, Offset(x, y), style = Stroke(1f))
            }
        }
        block(NxtPlan.FRAME, NxtColours.FRAME, FRAME_CORNER)
        for (slot in NxtPlan.SPEAKER) block(slot, if (isSounding) NxtColours.SPEAKING else NxtColours.SPEAKER, 2f)
        if (isSounding) drawSoundWaves()
        drawCircle(
            if (isSending) NxtColours.RADIO else NxtColours.FACE_EDGE,
            NxtPlan.RADIO_LAMP_RADIUS,
            NxtPlan.RADIO_LAMP,
        )
    }
}

/** Two arcs beside the loudspeaker. */
private fun DrawScope.drawSoundWaves() {
    val middle = NxtPlan.SPEAKER[NxtPlan.SPEAKER.size / 2].centerLeft
    for (radius in listOf(6f, 11f)) {
        drawArc(
            NxtColours.SPEAKING,
            WAVE_START,
            WAVE_SWEEP,
            false,
            middle - Offset(radius, radius),
            Size(2 * radius, 2 * radius),
            style = Stroke(2f),
        )
    }
}

/** A button from its side and top: [down] ones sink. Fills the draw area. */
internal fun DrawScope.drawNxtButton(shape: Path, colour: Color, edge: Color, sunk: Float, down: Boolean) {
    drawPath(shape, edge)
    withTransform({
        translate(0f, if (down) sunk else 0f)
        scale(1f, (size.height - sunk) / size.height, Offset.Zero)
    }) { drawPath(shape, colour) }
}

/** A plug with its cable above or below; an empty socket is only its hole. Fills the draw area. */
internal fun DrawScope.drawPlug(colour: Color, isAbove: Boolean, isPlugged: Boolean, unit: Float) {
    val cable = NxtPlan.CABLE_LENGTH * unit
    val top = if (isAbove) cable else 0f
    val block = Rect(0f, top, size.width, size.height - if (isAbove) 0f else cable)
    val corner = CornerRadius(NxtPlan.PLUG_CORNER * unit)
    if (!isPlugged) {
        drawRoundRect(NxtColours.EDGE, block.topLeft, block.size, corner)
        val hole = block.deflate(unit * 1.5f)
        drawRoundRect(NxtColours.SOCKET, hole.topLeft, hole.size, corner)
        return
    }
    val width = NxtPlan.CABLE_WIDTH * unit
    val start = if (isAbove) 0f else block.bottom - unit
    drawRect(NxtColours.PLUG_EDGE, Offset((size.width - width) / 2, start), Size(width, cable + unit))
    drawRoundRect(NxtColours.PLUG_EDGE, block.topLeft, block.size, corner)
    val face = block.deflate(unit)
    drawRoundRect(colour, face.topLeft, face.size, corner)
    // The latch of the plug.
    val latch = Size(width * LATCH_WIDTH, unit * LATCH_HEIGHT)
    val y = if (isAbove) block.top else block.bottom - latch.height
    drawRect(NxtColours.LABEL.copy(alpha = LATCH_ALPHA), Offset((size.width - latch.width) / 2, y), latch)
}

private fun DrawScope.block(bounds: Rect, colour: Color, corner: Float) =
    drawRoundRect(colour, bounds.topLeft, bounds.size, CornerRadius(corner))

private const val FRAME_CORNER = 8f
private const val WAVE_START = 130f
private const val WAVE_SWEEP = 100f
private const val LATCH_WIDTH = 1.2f
private const val LATCH_HEIGHT = 4f
private const val LATCH_ALPHA = 0.28f
