package robotran.simulation.messages

import robotran.rcxrom.sensors.SensorKind

/** The sentences about the sensors of a robot. */
interface SensorMessages {
    /** A program expects a sensor of this [kind] on [port], 1..3, but none is plugged in there. */
    fun missingSensor(port: Int, kind: SensorKind): String
}
