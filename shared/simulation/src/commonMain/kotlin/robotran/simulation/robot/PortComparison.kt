package robotran.simulation.robot

import robotran.brick.program.RuntimeWarning
import robotran.brick.sensors.ExpectedSensor
import robotran.simulation.messages.SensorMessages
import robotran.simulation.state.MissingSensor
import robotran.simulation.state.MissingSensors
import robotran.world.RobotDescription

/** Compares what a program expects at the ports of [robot] with what is plugged in there. */
internal class PortComparison(private val robot: RobotDescription, private val messages: SensorMessages) {
    private var compared: List<ExpectedSensor> = emptyList()
    private var missing: MissingSensors? = null

    /** What is missing of the [expected] sensors, at most one per port; the same object for the same list. */
    fun among(expected: List<ExpectedSensor>): MissingSensors? {
        if (expected !== compared) {
            compared = expected
            missing = expected.filterNot(::isPlugged).distinctBy { it.port }.takeIf { it.isNotEmpty() }?.let(::missing)
        }
        return missing
    }

    private fun labelOf(sensor: ExpectedSensor): String = robot.brick.inputLabel(sensor.port)

    private fun isPlugged(sensor: ExpectedSensor) = robot.parts.any { it.port == sensor.port && it.kind == sensor.kind }

    private fun missing(sensors: List<ExpectedSensor>) = MissingSensors(
        sensors.map { MissingSensor(it.port, labelOf(it), it.kind, warning(listOf(it))) }.sortedBy { it.port },
        warning(sensors),
    )

    /** A warning about [sensors], on the line of the first of them. */
    private fun warning(sensors: List<ExpectedSensor>): RuntimeWarning {
        val ports = sensors.sortedBy { it.port }.groupBy({ it.kind }, ::labelOf)
        return RuntimeWarning(
            messages.missingSensors(ports),
            sensors.first().sourceLine,
            sensors.first().sourceFile,
        )
    }
}
