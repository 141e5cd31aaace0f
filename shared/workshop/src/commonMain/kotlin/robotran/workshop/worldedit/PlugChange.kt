package robotran.workshop.worldedit

import robotran.simulation.state.MissingSensor
import robotran.world.PortSensor
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.worldediting.Edit
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef

/**
 * Missing sensors plugged into the ports of a robot, and how to take them out again.
 *
 * @param robot the robot before the change.
 */
internal class PlugChange(private val robot: RobotPlacement, missing: List<MissingSensor>) {
    private val plugs: Map<Int, List<PortSensor>> = missing.associate { it.port - 1 to it.plug }
    private val unplugged: Map<Int, List<PortSensor>> = plugs.mapValues { (port, _) -> robot.ports[port] }

    /** Plugs the sensors in; null if [world] does not have the robot. */
    fun editOf(world: World): Edit? = edit(world, plugs)

    /**
     * Restores the ports and nothing else, whatever has changed besides them; null if [world] does not have the robot
     * or the plugged sensors any more.
     */
    fun undoOf(world: World): Edit? {
        val ports = robotIn(world)?.value?.ports ?: return null
        return if (plugs.all { (port, sensors) -> ports[port] == sensors }) edit(world, unplugged) else null
    }

    private fun edit(world: World, sensors: Map<Int, List<PortSensor>>): Edit? {
        val (index, place) = robotIn(world) ?: return null
        val ports = place.ports.mapIndexed { port, plugged -> sensors[port] ?: plugged }
        return Edit.Change(ElementRef(ElementKind.ROBOT, index), Element.OfRobot(place.withPorts(ports)))
    }

    private fun robotIn(world: World): IndexedValue<RobotPlacement>? =
        world.robots.withIndex().find { it.value.name == robot.name }
}
