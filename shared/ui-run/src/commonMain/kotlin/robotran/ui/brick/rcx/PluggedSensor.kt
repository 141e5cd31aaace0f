package robotran.ui.brick.rcx

import robotran.brick.sensors.SensorKind
import robotran.rcxrom.sensors.SensorState
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.world.PortSensor

/**
 * A sensor on an input port, as it is shown.
 *
 * @property kind null for nothing.
 */
internal enum class PluggedSensor(val words: Label, val kind: SensorKind?) {
    LEFT_BUMPER(RunTexts::leftBumper, SensorKind.TOUCH),
    RIGHT_BUMPER(RunTexts::rightBumper, SensorKind.TOUCH),
    TOUCH(RunTexts::sensorTouch, SensorKind.TOUCH),
    LIGHT_SENSOR(CommonTexts::lightSensor, SensorKind.LIGHT),
    ROTATION(CommonTexts::sensorRotation, SensorKind.ROTATION),
    TEMPERATURE(CommonTexts::sensorTemperature, SensorKind.TEMPERATURE),
    NOTHING(RunTexts::sensorNone, null),
    ;

    /** Whether [sensor] is a pressed switch. */
    fun isPressed(sensor: SensorState): Boolean = kind == SensorKind.TOUCH && sensor.boolean

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
