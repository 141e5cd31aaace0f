package robotran.simulation.messages

import robotran.brick.sensors.SensorKind

/** The sentences about the sensors of a robot. */
interface SensorMessages {
    /**
     * A program expects sensors that are not plugged in.
     *
     * @param ports for each kind, in the order to name them, its ports, 1..3; not empty.
     */
    fun missingSensors(ports: Map<SensorKind, List<Int>>): String
}
