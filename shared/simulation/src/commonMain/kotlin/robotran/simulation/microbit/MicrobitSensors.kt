package robotran.simulation.microbit

import robotran.brick.sensors.SensorKind
import robotran.microbit.buggy.Buggy
import robotran.microbit.buggy.MicrobitSensor
import robotran.world.RobotDescription
import robotran.world.SensorPart

/** How the buggy of a robot with a micro:bit is driven; null for a robot with another brick. */
val RobotDescription.buggyWiring: Buggy?
    get() = buggy?.let { Buggy.of(it.kind, it.pins) }

/**
 * What is on the ports of a robot with a micro:bit, by their numbers from 1. The buggy decides which sensor belongs on
 * a port; another part there cannot be read.
 */
val RobotDescription.microbitSensors: Map<Int, MicrobitSensor>
    get() = buggyWiring?.sensors.orEmpty().filter { (port, sensor) -> partFor(port, sensor) != null }

/** The part of the robot that is the [sensor] of its buggy on [port]; null if it is not there. */
internal fun RobotDescription.partFor(port: Int, sensor: MicrobitSensor): SensorPart? {
    val kind = when (sensor) {
        is MicrobitSensor.Line -> SensorKind.LIGHT
        MicrobitSensor.Sonar -> SensorKind.ULTRASONIC
    }
    return parts.filterIsInstance<SensorPart>().firstOrNull { it.port == port && it.sensor == kind }
}
