package robotran.ui.sheet

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.uikit.*
import robotran.world.Paper

/** A frame around what a pupil's robot drew, as around a picture on a wall; nothing without a drawing. */
fun DrawScope.drawDrawingFrame(session: SessionState, paper: Paper, transform: SheetTransform) {
    if (session.ink.lengthCentimetres < LEAST) return
    val box = drawnBox(session)?.grown(MARGIN) ?: return
    val room = Rect(
        transform.toPixels(box.left.coerceIn(0.0, paper.width), box.top.coerceIn(0.0, paper.height)),
        transform.toPixels(box.right.coerceIn(0.0, paper.width), box.bottom.coerceIn(0.0, paper.height)),
    )
    for ((colour, width) in listOf(RobotranColours.CASING to CASING, RobotranColours.RUN_GREEN to LINE)) {
        drawRoundRect(
            colour,
            room.topLeft,
            room.size,
            CornerRadius(Corners.SMALL.toPx()),
            style = Stroke(width.toPx()),
        )
    }
}

/** In centimetres: less ink is a dot, no drawing. */
private const val LEAST = 3.0
private const val MARGIN = 2.0
private val LINE = 3.dp
private val CASING = 6.dp
