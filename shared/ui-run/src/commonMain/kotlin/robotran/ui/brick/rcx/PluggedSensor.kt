package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.scale
import robotran.rcxrom.sensors.SensorState
import robotran.ui.common.BrickColours
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.world.PortSensor

/**
 * A sensor on an input port, as it is shown.
 *
 * @property isSwitch whether it can be pressed.
 */
internal enum class PluggedSensor(val words: Label, val isSwitch: Boolean = false) {
    LEFT_BUMPER(RunTexts::leftBumper, isSwitch = true),
    RIGHT_BUMPER(RunTexts::rightBumper, isSwitch = true),
    TOUCH(RunTexts::sensorTouch, isSwitch = true),
    LIGHT_SENSOR(CommonTexts::lightSensor),
    ROTATION(CommonTexts::sensorRotation),
    TEMPERATURE(CommonTexts::sensorTemperature),
    NOTHING(RunTexts::sensorNone),
    ;

    /** Whether [sensor] is a pressed switch. */
    fun isPressed(sensor: SensorState): Boolean = isSwitch && sensor.boolean

    companion object {
        /** The sensor to show for [plugged], the sensors on one port: the first that can be pressed, or the first. */
        fun of(plugged: List<PortSensor>): PluggedSensor = when (
            plugged.find { it == PortSensor.TOUCH }
                ?: plugged.firstOrNull()
        ) {
            PortSensor.LEFT_BUMPER -> LEFT_BUMPER
            PortSensor.RIGHT_BUMPER -> RIGHT_BUMPER
            PortSensor.TOUCH -> TOUCH
            PortSensor.LIGHT -> LIGHT_SENSOR
            PortSensor.LEFT_ROTATION, PortSensor.RIGHT_ROTATION -> ROTATION
            PortSensor.TEMPERATURE -> TEMPERATURE
            null -> NOTHING
        }
    }
}

/** A push button, a lamp, a wheel with an arrow or a thermometer; fills the draw area. */
internal fun DrawScope.drawPlugged(sensor: PluggedSensor, pressed: Boolean) =
    scale(size.width / ICON_UNITS, Offset.Zero) {
        val colour = BrickColours.LABEL
        when (sensor) {
            PluggedSensor.LEFT_BUMPER, PluggedSensor.RIGHT_BUMPER, PluggedSensor.TOUCH -> {
                drawRoundRect(colour, Offset(1f, 9f), Size(14f, 5f), CornerRadius(1.5f))
                drawRoundRect(colour, Offset(5f, if (pressed) 7f else 3f), Size(6f, 7f), CornerRadius(1.5f))
            }

            PluggedSensor.LIGHT_SENSOR -> {
                drawCircle(colour, 3.5f, Offset(8f, 9f))
                for ((from, to) in RAYS) drawLine(colour, from, to, RAY_WIDTH)
            }

            PluggedSensor.ROTATION -> {
                drawArc(colour, -60f, 300f, false, Offset(2.5f, 2.5f), Size(11f, 11f), style = Stroke(RAY_WIDTH))
                drawPath(polygon(8f, 0.5f, 12.5f, 3.5f, 8f, 6f), colour)
            }

            PluggedSensor.TEMPERATURE -> {
                drawRoundRect(colour, Offset(6.5f, 1f), Size(3f, 10f), CornerRadius(1.5f))
                drawCircle(colour, 3.2f, Offset(8f, 12f))
            }

            PluggedSensor.NOTHING -> {}
        }
    }

private const val ICON_UNITS = 16f
private const val RAY_WIDTH = 1.6f

/** From the lamp outwards. */
private val RAYS = listOf(
    Offset(8f, 4f) to Offset(8f, 1f),
    Offset(4.5f, 5.5f) to Offset(2.5f, 3.5f),
    Offset(11.5f, 5.5f) to Offset(13.5f, 3.5f),
    Offset(3f, 9f) to Offset(0.5f, 9f),
    Offset(13f, 9f) to Offset(15.5f, 9f),
)
