package robotran.workshop.worldedit

import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit

/**
 * A whole robot replaced by another one, and how to bring it back.
 *
 * @param before the robot before the change.
 * @param after how it is built then.
 */
internal class RobotChange(private val before: RobotPlacement, private val after: RobotDescription) {
    /** Replaces the robot where it stands; null if [world] does not have it. */
    fun editOf(world: World): WorldEdit? = edit(world) { it.copy(description = after, draft = null) }

    /** Brings it back where it stands now; null if [world] does not have the other one any more. */
    fun undoOf(world: World): WorldEdit? {
        val now = robotIn(world)?.value ?: return null
        if (now.description != after || now.draft != null) return null
        return edit(world) { it.copy(description = before.description, draft = before.draft) }
    }

    private fun edit(world: World, change: (RobotPlacement) -> RobotPlacement): WorldEdit? {
        val (index, place) = robotIn(world) ?: return null
        return WorldEdit.Change(ElementRef(ElementKind.ROBOT, index), Element.OfRobot(change(place)))
    }

    private fun robotIn(world: World): IndexedValue<RobotPlacement>? =
        world.robots.withIndex().find { it.value.name == before.name }
}
