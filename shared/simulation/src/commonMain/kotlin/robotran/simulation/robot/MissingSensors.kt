package robotran.simulation.robot

import robotran.rcxrom.program.RuntimeWarning
import robotran.rcxrom.sensors.ExpectedSensor
import robotran.simulation.messages.SensorMessages
import robotran.simulation.state.MissingSensor
import robotran.simulation.state.kind
import robotran.world.RobotPlacement

/** Compares what a program expects at the ports of [place] with what is plugged in there. */
internal class MissingSensors(private val place: RobotPlacement, private val messages: SensorMessages) {
    private var compared: List<ExpectedSensor> = emptyList()
    private var missing: List<MissingSensor> = emptyList()

    /** What is missing of the [expected] sensors, at most one per port; the same list for the same list. */
    fun among(expected: List<ExpectedSensor>): List<MissingSensor> {
        if (expected !== compared) {
            compared = expected
            missing = expected.filterNot(::isPlugged).distinctBy { it.port }.map(::missing)
        }
        return missing
    }

    private fun isPlugged(sensor: ExpectedSensor) = place.ports[sensor.port - 1].any { it.kind == sensor.kind }

    private fun missing(sensor: ExpectedSensor) = MissingSensor(
        sensor.port,
        sensor.kind,
        RuntimeWarning(messages.missingSensor(sensor.port, sensor.kind), sensor.sourceLine, sensor.sourceFile),
    )
}
