package robotran.ui.brick.front

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.scale
import robotran.brick.sensors.SensorKind
import robotran.ui.common.BrickColours
import robotran.uikit.*

/**
 * What a sensor looks like, or what it is about; fills the draw area.
 *
 * @param ink the colour of its lines.
 * @param seen the colour that a colour sensor sees; null if it sees none.
 */
internal fun DrawScope.drawSensorIcon(kind: SensorKind, isPressed: Boolean, ink: Color, seen: Color? = null) =
    scale(size.width / ICON_UNITS, Offset.Zero) {
        when (kind) {
            SensorKind.TOUCH -> {
                drawRoundRect(ink, Offset(1f, 9f), Size(14f, 5f), CornerRadius(1.5f))
                drawRoundRect(ink, Offset(5f, if (isPressed) 7f else 3f), Size(6f, 7f), CornerRadius(1.5f))
            }

            SensorKind.LIGHT, SensorKind.RCX_LIGHT -> {
                drawCircle(ink, 3.5f, Offset(8f, 9f))
                for ((from, to) in RAYS) drawLine(ink, from, to, LINE)
            }

            SensorKind.ULTRASONIC -> {
                drawRoundRect(ink, Offset(0.5f, 4f), Size(15f, 8f), CornerRadius(3f))
                for (x in listOf(4.4f, 11.6f)) {
                    drawCircle(BrickColours.SENSOR_LIGHT, 2.7f, Offset(x, 8f))
                    drawCircle(BrickColours.SENSOR_ORANGE, 1.3f, Offset(x, 8f))
                }
            }

            SensorKind.SOUND -> {
                drawRoundRect(ink, Offset(1f, 5.5f), Size(3.5f, 5f), CornerRadius(1f))
                drawPath(polygon(4f, 6f, 8f, 2.5f, 8f, 13.5f, 4f, 10f), ink)
                for (radius in listOf(3f, 6f)) arc(ink, Offset(8.5f, 8f), radius, -45f, 90f)
            }

            SensorKind.COLOUR, SensorKind.HITECHNIC_COLOUR -> {
                drawCircle(ink, 7f, Offset(8f, 8f))
                if (seen != null) {
                    drawCircle(seen, 5.4f, Offset(8f, 8f))
                } else {
                    for ((place, part) in PARTS) drawCircle(part, 2.2f, place)
                }
            }

            SensorKind.COMPASS, SensorKind.MINDSENSORS_COMPASS -> {
                drawCircle(ink, 6.8f, Offset(8f, 8f), style = Stroke(LINE))
                drawPath(polygon(8f, 1.8f, 10.3f, 8f, 5.7f, 8f), BrickColours.SENSOR_ORANGE)
                drawPath(polygon(8f, 14.2f, 5.7f, 8f, 10.3f, 8f), ink)
            }

            SensorKind.GYRO, SensorKind.ROTATION -> {
                drawArc(ink, -60f, 300f, false, Offset(2.5f, 2.5f), Size(11f, 11f), style = Stroke(LINE))
                drawPath(polygon(8f, 0.5f, 12.5f, 3.5f, 8f, 6f), ink)
                if (kind == SensorKind.GYRO) drawCircle(ink, 1.6f, Offset(8f, 8f))
            }

            SensorKind.HITECHNIC_ACCELERATION, SensorKind.MINDSENSORS_ACCELERATION -> {
                drawLine(ink, Offset(2f, 14f), Offset(13f, 14f), LINE)
                drawLine(ink, Offset(2f, 14f), Offset(2f, 3f), LINE)
                drawPath(polygon(2f, 0.5f, 4.5f, 4f, 0f, 4f), ink)
                drawPath(polygon(15.5f, 14f, 12f, 16f, 12f, 11.5f), ink)
            }

            SensorKind.RCX_LINK -> {
                drawRoundRect(ink, Offset(1f, 5f), Size(5f, 6f), CornerRadius(1f))
                for (radius in listOf(3f, 6f)) arc(ink, Offset(7f, 8f), radius, -45f, 90f)
            }

            SensorKind.INFRARED_SEEKER, SensorKind.INFRARED_SEEKER_2 -> {
                drawArc(ink, 180f, 180f, true, Offset(1f, 4f), Size(14f, 14f))
                for (x in listOf(4f, 8f, 12f)) drawCircle(BrickColours.SENSOR_LIGHT, 1.4f, Offset(x, 9f))
            }

            SensorKind.OPTICAL_DISTANCE -> {
                drawRoundRect(ink, Offset(0.5f, 4f), Size(15f, 8f), CornerRadius(1f))
                for (x in listOf(4.4f, 11.6f)) drawCircle(BrickColours.SENSOR_LIGHT, 2.4f, Offset(x, 8f))
            }

            SensorKind.TEMPERATURE, SensorKind.NXT_TEMPERATURE -> {
                drawRoundRect(ink, Offset(6.5f, 1f), Size(3f, 10f), CornerRadius(1.5f))
                drawCircle(ink, 3.2f, Offset(8f, 12f))
            }
        }
    }

private fun DrawScope.arc(colour: Color, middle: Offset, radius: Float, from: Float, sweep: Float) = drawArc(
    colour,
    from,
    sweep,
    false,
    middle - Offset(radius, radius),
    Size(2 * radius, 2 * radius),
    style = Stroke(LINE),
)

private const val ICON_UNITS = 16f
private const val LINE = 1.6f

/** From the lamp outwards. */
private val RAYS = listOf(
    Offset(8f, 4f) to Offset(8f, 1f),
    Offset(4.5f, 5.5f) to Offset(2.5f, 3.5f),
    Offset(11.5f, 5.5f) to Offset(13.5f, 3.5f),
    Offset(3f, 9f) to Offset(0.5f, 9f),
    Offset(13f, 9f) to Offset(15.5f, 9f),
)

/** The red, green and blue of a colour sensor that sees nothing yet. */
private val PARTS = listOf(
    Offset(8f, 5f) to RobotranColours.ON_OFF_RED,
    Offset(5.3f, 9.8f) to RobotranColours.RUN_GREEN,
    Offset(10.7f, 9.8f) to BrickColours.SENSOR_BLUE,
)
