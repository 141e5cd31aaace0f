package robotran.workshop.worldedit

import robotran.simulation.state.MissingSensor
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.pluggedSensors
import robotran.world.robot.withSensor
import robotran.world.withPlugged
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit

/**
 * Missing sensors plugged into the ports of a robot, and how to take them out again.
 *
 * @param robot the robot before the change.
 */
internal class PlugChange(private val robot: RobotPlacement, private val missing: List<MissingSensor>) {
    private val ports = missing.map { it.port }.toSet()

    /** Plugs the sensors in; null if [world] does not have the robot. */
    fun editOf(world: World): WorldEdit? = edit(world) { it.plugged() }

    /**
     * Restores the ports and nothing else, whatever has changed besides them; null if [world] does not have the robot
     * or the plugged sensors any more.
     */
    fun undoOf(world: World): WorldEdit? {
        val now = robotIn(world)?.value?.description ?: return null
        if (now.plugs() != robot.description.plugged().plugs()) return null
        return edit(world) { it.unplugged() }
    }

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

    private fun edit(world: World, change: (RobotDescription) -> RobotDescription): WorldEdit? {
        val (index, place) = robotIn(world) ?: return null
        val changed = place.copy(description = change(place.description))
        return WorldEdit.Change(ElementRef(ElementKind.ROBOT, index), Element.OfRobot(changed))
    }

    private fun robotIn(world: World): IndexedValue<RobotPlacement>? =
        world.robots.withIndex().find { it.value.name == robot.name }
}
