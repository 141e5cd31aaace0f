package robotran.ui.robot

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.robotediting.RobotItem
import robotran.ui.sheet.RobotColours
import robotran.ui.sheet.SheetColours
import robotran.uikit.*

/** Draws a palette item as it looks on the plan; [ink] is the colour of lines. */
internal fun DrawScope.drawRobotItem(item: RobotItem, ink: Color) {
    val unit = size.width / Icon.UNITS
    drawContext.transform.scale(unit, unit, Offset.Zero)
    when (item) {
        RobotItem.BUMPER -> {
            box(RobotColours.BUMPER, 2f, 7f, 20f, 5f, ink)
            box(RobotColours.BUMPER_EDGE, 10f, 12f, 4f, 7f, ink)
        }

        RobotItem.FINGER_TOUCH -> {
            box(RobotColours.BUMPER, 6f, 8f, 12f, 13f, ink)
            disc(RobotranColours.ON_OFF_RED, 12f, 7f, 3.5f, ink)
        }

        RobotItem.LIGHT, RobotItem.COLOUR, RobotItem.HITECHNIC_COLOUR, RobotItem.RCX_LIGHT -> drawLooking(item, ink)

        RobotItem.SOUND -> {
            box(RobotColours.NXT_GREY, 5f, 5f, 14f, 14f, ink)
            disc(RobotColours.CHASSIS, 12f, 12f, 4f, ink)
        }

        RobotItem.GYRO, RobotItem.COMPASS, RobotItem.MINDSENSORS_COMPASS,
        RobotItem.HITECHNIC_ACCELERATION, RobotItem.MINDSENSORS_ACCELERATION,
        -> drawInstrument(item, ink)

        RobotItem.ROTATION -> {
            disc(RobotColours.TYRE, 12f, 12f, 9.5f, ink)
            disc(RobotColours.BUMPER, 12f, 12f, 5f, ink)
            drawLine(RobotColours.CHASSIS, Offset(12f, 12f), Offset(12f, 8f), 1.8f, StrokeCap.Round)
        }

        RobotItem.TEMPERATURE, RobotItem.NXT_TEMPERATURE -> {
            box(RobotColours.NXT_FACE, 9.5f, 2f, 5f, 14f, ink)
            disc(RobotColours.PEN_TIP_DOWN, 12f, 18f, 4f, ink)
            drawLine(RobotColours.PEN_TIP_DOWN, Offset(12f, 16f), Offset(12f, 9f), 2f, StrokeCap.Round)
        }

        RobotItem.ULTRASONIC, RobotItem.RCX_LINK, RobotItem.OPTICAL_DISTANCE,
        RobotItem.INFRARED_SEEKER, RobotItem.INFRARED_SEEKER_2,
        -> drawFarSighted(item, ink)

        RobotItem.CASTER -> {
            disc(RobotBenchColours.CASTER, 12f, 12f, 8f, ink)
            disc(RobotColours.NXT_FACE, 12f, 12f, 3f, ink)
        }

        RobotItem.PEN -> {
            disc(RobotColours.CLIP, 12f, 12f, 9f, ink)
            disc(RobotColours.PEN_TIP_DOWN, 12f, 12f, 4f, ink)
        }
    }
}

/** What sees the floor. */
private fun DrawScope.drawLooking(item: RobotItem, ink: Color) {
    when (item) {
        RobotItem.COLOUR -> {
            box(RobotColours.NXT_FACE, 5f, 4f, 14f, 12f, ink)
            disc(RobotColours.PEN_TIP_DOWN, 8.5f, 10f, 1.8f, ink)
            disc(RobotranColours.RUN_GREEN, 12f, 10f, 1.8f, ink)
            disc(RobotColours.LIGHT_SENSOR, 15.5f, 10f, 1.8f, ink)
        }

        RobotItem.HITECHNIC_COLOUR -> {
            box(RobotColours.CHASSIS, 5f, 4f, 14f, 12f, ink)
            disc(RobotColours.NXT_FACE, 9f, 10f, 2.2f, ink)
            disc(RobotColours.LIGHT_SENSOR, 15f, 10f, 2.2f, ink)
        }

        RobotItem.RCX_LIGHT -> {
            box(RobotColours.LIGHT_SENSOR, 5f, 6f, 14f, 10f, ink)
            disc(RobotColours.PEN_TIP_DOWN, 12f, 11f, 2.2f, ink)
        }

        else -> {
            box(RobotColours.LIGHT_SENSOR, 5f, 4f, 14f, 12f, ink)
            disc(RobotColours.PEN_TIP_DOWN, 9f, 10f, 2.2f, ink)
        }
    }
    spot()
}

/** What measures the robot's own movement. */
private fun DrawScope.drawInstrument(item: RobotItem, ink: Color) {
    val isOfMindsensors = item == RobotItem.MINDSENSORS_COMPASS || item == RobotItem.MINDSENSORS_ACCELERATION
    box(if (isOfMindsensors) RobotColours.CLIP else RobotColours.CHASSIS, 4f, 4f, 16f, 16f, ink)
    when (item) {
        RobotItem.GYRO -> {
            val line = Stroke(2f, cap = StrokeCap.Round)
            drawArc(RobotColours.NXT_FACE, 200f, 250f, false, Offset(7.5f, 7.5f), Size(9f, 9f), style = line)
        }

        RobotItem.COMPASS, RobotItem.MINDSENSORS_COMPASS -> {
            disc(RobotColours.NXT_FACE, 12f, 12f, 6f, ink)
            drawLine(RobotColours.PEN_TIP_DOWN, Offset(12f, 12f), Offset(12f, 7.5f), 2f, StrokeCap.Round)
        }

        else -> {
            drawLine(RobotColours.NXT_FACE, Offset(8f, 16f), Offset(8f, 7f), 2f, StrokeCap.Round)
            drawLine(RobotColours.NXT_FACE, Offset(8f, 16f), Offset(17f, 16f), 2f, StrokeCap.Round)
        }
    }
}

/** What senses something ahead. */
private fun DrawScope.drawFarSighted(item: RobotItem, ink: Color) {
    when (item) {
        RobotItem.ULTRASONIC -> {
            box(RobotColours.NXT_GREY, 2f, 9f, 20f, 10f, ink)
            for (x in listOf(7.5f, 16.5f)) {
                disc(RobotColours.CHASSIS, x, 14f, 3.8f, ink)
                disc(RobotColours.ORANGE, x, 14f, 1.8f, ink)
            }
            waves()
        }

        RobotItem.RCX_LINK -> {
            box(RobotColours.CLIP, 5f, 10f, 14f, 10f, ink)
            disc(RobotColours.CHASSIS, 12f, 15f, 2.5f, ink)
            waves()
        }

        RobotItem.OPTICAL_DISTANCE -> {
            box(RobotColours.CHASSIS, 2f, 9f, 20f, 8f, ink)
            for (x in listOf(7.5f, 16.5f)) disc(RobotColours.NXT_FACE, x, 13f, 2.6f, ink)
        }

        else -> {
            disc(RobotColours.CHASSIS, 12f, 13f, 8f, ink)
            val eyes = if (item == RobotItem.INFRARED_SEEKER) RobotColours.NXT_GREY else RobotColours.NXT_FACE
            for (x in listOf(7.5f, 12f, 16.5f)) disc(eyes, x, 11f, 1.6f, ink)
        }
    }
}

private fun DrawScope.box(colour: Color, x: Float, y: Float, width: Float, height: Float, ink: Color) {
    drawRoundRect(colour, Offset(x, y), Size(width, height), CornerRadius(2f))
    drawRoundRect(ink, Offset(x, y), Size(width, height), CornerRadius(2f), style = Stroke(1f))
}

private fun DrawScope.disc(colour: Color, x: Float, y: Float, radius: Float, ink: Color) {
    drawCircle(colour, radius, Offset(x, y))
    drawCircle(ink, radius, Offset(x, y), style = Stroke(1f))
}

/** What a sensor that looks down sees. */
private fun DrawScope.spot() {
    drawOval(SheetColours.SIGHT.copy(alpha = 0.5f), Offset(6f, 18f), Size(12f, 5f))
}

/** Sound ahead. */
private fun DrawScope.waves() {
    for (radius in listOf(3f, 6f)) {
        drawArc(
            SheetColours.SIGHT,
            225f,
            90f,
            false,
            Offset(12f - radius, 9f - radius),
            Size(radius * 2, radius * 2),
            style = Stroke(1.6f, cap = StrokeCap.Round),
        )
    }
}
