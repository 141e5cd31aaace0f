package robotran.ui.brick

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.scale
import org.jetbrains.compose.resources.StringResource
import robotran.rom.SensorState
import robotran.ui.resources.Res
import robotran.ui.resources.left_bumper
import robotran.ui.resources.light_sensor
import robotran.ui.resources.right_bumper

/** What the penbot has plugged into its input ports, by their order. */
internal enum class PluggedSensor(val words: StringResource) {
    LEFT_BUMPER(Res.string.left_bumper),
    LIGHT_SENSOR(Res.string.light_sensor),
    RIGHT_BUMPER(Res.string.right_bumper),
    ;

    /** Whether [sensor] is the port of a bumper that is pushed in. */
    fun isPressed(sensor: SensorState): Boolean = this != LIGHT_SENSOR && sensor.boolean

    companion object {
        /** @param port 1..3. */
        fun of(port: Int): PluggedSensor = entries[port - 1]
    }
}

/** A push button on its base, or a lamp; fills the draw area. */
internal fun DrawScope.drawPlugged(sensor: PluggedSensor, pressed: Boolean) = scale(size.width / ICON_UNITS, Offset.Zero) {
    val colour = BrickColours.LABEL
    if (sensor == PluggedSensor.LIGHT_SENSOR) {
        drawCircle(colour, 3.5f, Offset(8f, 9f))
        for ((from, to) in RAYS) drawLine(colour, from, to, RAY_WIDTH)
    } else {
        drawRoundRect(colour, Offset(1f, 9f), Size(14f, 5f), CornerRadius(1.5f))
        drawRoundRect(colour, Offset(5f, if (pressed) 7f else 3f), Size(6f, 7f), CornerRadius(1.5f))
    }
}

private const val ICON_UNITS = 16f
private const val RAY_WIDTH = 1.6f

/** From near the lamp outwards. */
private val RAYS = listOf(
    Offset(8f, 4f) to Offset(8f, 1f),
    Offset(4.5f, 5.5f) to Offset(2.5f, 3.5f),
    Offset(11.5f, 5.5f) to Offset(13.5f, 3.5f),
    Offset(3f, 9f) to Offset(0.5f, 9f),
    Offset(13f, 9f) to Offset(15.5f, 9f),
)
