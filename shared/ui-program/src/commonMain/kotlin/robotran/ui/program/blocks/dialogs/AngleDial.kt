package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.ProgressBarRangeInfo
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.progressBarRangeInfo
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.setProgress
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.round
import kotlin.math.sin

/**
 * A dial that shows how far the robot turns. It drives upwards before, and along the thick line afterwards.
 *
 * @param degrees any number; whole turns are not drawn.
 * @param isLeft whether it turns to the left.
 * @param onTurn receives 0..355, in steps of [STEP].
 */
@Composable
internal fun AngleDial(degrees: Double, isLeft: Boolean, diameter: Dp, onTurn: (Double) -> Unit) {
    val colours = LocalRobotranColours.current
    val words = BlockTexts.dial(spoken)
    val turn by rememberUpdatedState(onTurn)
    val left by rememberUpdatedState(isLeft)
    Canvas(
        Modifier
            .size(diameter)
            .testTag(ProgramTags.NUMBER_DIAL)
            .pointerInput(Unit) {
                awaitEachGesture {
                    val down = awaitFirstDown()
                    var place = down.position
                    while (true) {
                        turn(angleAt(place, Size(size.width.toFloat(), size.height.toFloat()), left))
                        val change = awaitPointerEvent().changes.firstOrNull { it.id == down.id } ?: break
                        change.consume()
                        if (!change.pressed) break
                        place = change.position
                    }
                }
            }
            .semantics {
                contentDescription = words
                progressBarRangeInfo = ProgressBarRangeInfo(degrees.toFloat(), 0f..FULL.toFloat())
                setProgress {
                    turn(round(it / STEP) * STEP)
                    true
                }
            },
    ) { drawDial(degrees, isLeft, colours) }
}

private fun angleAt(position: Offset, size: Size, isLeft: Boolean): Double {
    val clockwise =
        atan2((position.x - size.width / 2).toDouble(), (size.height / 2 - position.y).toDouble()) * HALF / PI
    val turned = if (isLeft) -clockwise else clockwise
    return (round(turned / STEP) * STEP + FULL) % FULL
}

private fun DrawScope.drawDial(degrees: Double, isLeft: Boolean, colours: RobotranColours) {
    val radius = size.minDimension / 2 - EDGE.toPx()
    drawCircle(colours.line, radius, center, style = Stroke(2.dp.toPx()))
    for (tick in 0..<TICKS) {
        val isLong = tick % LONG == 0
        val inner = radius - (if (isLong) 12.dp else 6.dp).toPx()
        val angle = FULL * tick / TICKS
        drawLine(colours.quiet, at(angle, inner), at(angle, radius), 2.dp.toPx(), StrokeCap.Round)
    }
    val sweep = (degrees % FULL).toFloat() * if (isLeft) -1 else 1
    val arc = radius * ARC
    drawArc(
        RobotranColours.YELLOW,
        UP,
        sweep,
        useCenter = true,
        Offset(center.x - arc, center.y - arc),
        Size(2 * arc, 2 * arc),
        alpha = SHADE,
    )
    drawHand(0.0, radius, colours.quiet, 3f)
    drawHand(sweep.toDouble(), radius, colours.onPane, 5f)
}

private fun DrawScope.drawHand(angle: Double, radius: Float, colour: Color, width: Float) =
    drawLine(colour, center, at(angle, radius), width.dp.toPx(), StrokeCap.Round)

/** The point at [angle] in degrees clockwise from above. */
private fun DrawScope.at(angle: Double, radius: Float): Offset {
    val radians = angle * PI / HALF
    return center + Offset((sin(radians) * radius).toFloat(), (-cos(radians) * radius).toFloat())
}

private val EDGE = 4.dp

/** The degrees of the smallest turn of the dial. */
private const val STEP = 5.0
private const val FULL = 360.0
private const val HALF = 180.0
private const val TICKS = 24

/** Each right angle has a long tick. */
private const val LONG = 6

/** Compose measures arcs from the right. */
private const val UP = -90f
private const val ARC = 0.6f
private const val SHADE = 0.6f
