package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import robotran.uikit.*
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

/**
 * The eyes of a robot in centimetres.
 *
 * @param eyes their middles.
 * @param lids the colour of its brick.
 * @param edge the colour of its brick's edge.
 */
internal fun DrawTarget.drawEyes(eyes: List<Offset>, face: PenbotFace, lids: Color, edge: Color) {
    eyes.forEach { middle -> drawEye(middle, face, lids, edge) }
}

private fun DrawTarget.drawEye(middle: Offset, face: PenbotFace, lids: Color, edge: Color) {
    val radius = RobotPlan.EYE_RADIUS
    if (face.lid >= CLOSED) {
        disc(middle, radius, lids)
        eyeArc(middle, edge, LOWER_LID, CLOSED_SWEEP, radius * LINE_RADIUS, Line(LID_EDGE, StrokeCap.Round))
    } else {
        disc(middle, radius, RobotColours.EYE)
        val pupil = middle + face.gaze * RobotPlan.GAZE
        disc(pupil, RobotPlan.PUPIL_RADIUS, RobotColours.PUPIL)
        disc(pupil + GLINT_PLACE, RobotPlan.PUPIL_RADIUS * GLINT, RobotColours.EYE)
        when (face.mood) {
            PenbotMood.CALM -> Unit

            // The upper lids hang down, most at the outer sides.
            PenbotMood.SULKING -> drawLid(middle, lids, edge, UPPER_LID + tilt(middle), SULKING_SWEEP)

            // The lower lids come up, as they do when somebody laughs.
            PenbotMood.GLAD -> drawLid(middle, lids, edge, LOWER_LID, GLAD_SWEEP)
        }
    }
    disc(middle, radius, fill = null, RobotColours.CHASSIS_EDGE, EDGE)
}

/** A segment of the eye around [angle]: the chord is the edge of the lid. */
private fun DrawTarget.drawLid(middle: Offset, lids: Color, edge: Color, angle: Float, sweep: Float) {
    eyeArc(middle, lids, angle, sweep, RobotPlan.EYE_RADIUS)
    val (from, to) = listOf(-1, 1).map { side ->
        val end = (angle + side * sweep / 2) * (PI / HALF_TURN)
        middle + Offset(cos(end).toFloat(), sin(end).toFloat()) * RobotPlan.EYE_RADIUS
    }
    line(from, to, edge, LID_EDGE)
}

private fun DrawTarget.eyeArc(
    middle: Offset,
    colour: Color,
    angle: Float,
    sweep: Float,
    radius: Float,
    line: Line? = null,
) = arc(middle, radius, angle - sweep / 2, sweep, colour, line)

/** Sulking lids hang down at the outer sides of the face. */
private fun tilt(middle: Offset): Float = if (middle.y < 0) TILT else -TILT

/** The angles of the middle of the lids: the face points forwards, so its upper side is behind. */
private const val UPPER_LID = 180f
private const val LOWER_LID = 0f

/** In degrees of the eye's rim. */
private const val SULKING_SWEEP = 170f
private const val GLAD_SWEEP = 130f
private const val CLOSED_SWEEP = 150f
private const val TILT = 28f

private const val CLOSED = 0.5f
private const val HALF_TURN = 180.0
private const val EDGE = 0.16f
private const val LID_EDGE = 0.2f

/** Relative to the radius of an eye. */
private const val LINE_RADIUS = 0.6f

/** The size of the glint relative to the pupil, and its place in it. */
private const val GLINT = 0.34f
private val GLINT_PLACE = Offset(0.18f, -0.18f)
