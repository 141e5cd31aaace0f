package robotran.workshop.worldedit

import robotran.simulation.state.MissingSensor
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.pluggedSensors
import robotran.world.robot.withSensor
import robotran.world.withPlugged
import robotran.worldediting.WorldEdit

/**
 * Missing sensors plugged into the ports of a robot. Taking them out restores the ports.
 *
 * @param robot the robot before the change.
 */
internal class PlugChange(private val robot: RobotPlacement, private val missing: List<MissingSensor>) : RobotChange {
    private val ports = missing.map { it.port }.toSet()

    override fun editOf(world: World): WorldEdit? = edit(world) { it.plugged() }

    override fun undoOf(world: World): WorldEdit? {
        val now = world.robots.find { it.name == robot.name }?.description ?: return null
        if (now.plugs() != robot.description.plugged().plugs()) return null
        return edit(world) { it.unplugged() }
    }

    private fun edit(world: World, change: (RobotDescription) -> RobotDescription): WorldEdit? =
        world.withRobot(robot.name) { it.copy(description = change(it.description)) }

    /** With what was on the ports before. */
    private fun RobotDescription.unplugged(): RobotDescription {
        val before = robot.description
        if (parts == before.plugged().parts) return copy(parts = before.parts)
        val sensors = pluggedSensors.mapIndexed { port, now ->
            if (port + 1 in ports) before.pluggedSensors[port] else now
        }
        return withPlugged(sensors)
    }

    private fun RobotDescription.plugged(): RobotDescription =
        missing.fold(this) { description, sensor -> description.withSensor(sensor.kind, sensor.port) }

    /** What is on the ports of the missing sensors. */
    private fun RobotDescription.plugs(): List<RobotPart> = parts.filter { it.port in ports }
}
