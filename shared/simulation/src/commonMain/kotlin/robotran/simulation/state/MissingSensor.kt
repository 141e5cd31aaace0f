package robotran.simulation.state

import robotran.brick.program.RuntimeWarning
import robotran.brick.sensors.SensorKind
import robotran.world.PortSensor

/**
 * A sensor that a program expects at a port of a robot that has none of its kind there.
 *
 * @property port from 1.
 * @property remark says so of this sensor alone, with the line of the program.
 */
data class MissingSensor(val port: Int, val kind: SensorKind, val remark: RuntimeWarning) {
    /**
     * The penbot's sensors to plug into [port] so that it has one of this [kind]. On the ports 1 and 3 these are those
     * of the left and the right; a touch sensor on port 2 is pressed by both bumpers. Empty for sensors of an NXT.
     */
    val plug: List<PortSensor>
        get() = when (kind) {
            SensorKind.TOUCH -> {
                when (port) {
                    FIRST_PORT -> listOf(PortSensor.LEFT_BUMPER)
                    LAST_PORT -> listOf(PortSensor.RIGHT_BUMPER)
                    else -> listOf(PortSensor.LEFT_BUMPER, PortSensor.RIGHT_BUMPER)
                }
            }

            SensorKind.TEMPERATURE -> {
                listOf(PortSensor.TEMPERATURE)
            }

            SensorKind.LIGHT -> {
                listOf(PortSensor.LIGHT)
            }

            SensorKind.ROTATION -> {
                listOf(if (port == LAST_PORT) PortSensor.RIGHT_ROTATION else PortSensor.LEFT_ROTATION)
            }

            SensorKind.ULTRASONIC, SensorKind.SOUND, SensorKind.COLOUR, SensorKind.COMPASS, SensorKind.GYRO -> {
                emptyList()
            }
        }

    private companion object {
        const val FIRST_PORT = 1
        const val LAST_PORT = 3
    }
}

/** The kind of this sensor for a program. */
internal val PortSensor.kind: SensorKind
    get() = when (this) {
        PortSensor.LEFT_BUMPER, PortSensor.RIGHT_BUMPER, PortSensor.TOUCH -> SensorKind.TOUCH
        PortSensor.LIGHT -> SensorKind.LIGHT
        PortSensor.LEFT_ROTATION, PortSensor.RIGHT_ROTATION -> SensorKind.ROTATION
        PortSensor.TEMPERATURE -> SensorKind.TEMPERATURE
    }
