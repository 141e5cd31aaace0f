package robotran.simulation.state

import robotran.brick.program.RuntimeWarning
import robotran.brick.sensors.SensorKind

/**
 * A sensor that a program expects at a port of a robot that has none of its kind there;
 * [robotran.world.robot.withSensor] plugs one in.
 *
 * @property port from 1.
 * @property label what is printed beside that port.
 * @property warning says so of this sensor alone, with the line of the program.
 */
data class MissingSensor(val port: Int, val label: String, val kind: SensorKind, val warning: RuntimeWarning)
