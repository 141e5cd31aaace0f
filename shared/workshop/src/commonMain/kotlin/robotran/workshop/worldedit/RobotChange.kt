package robotran.workshop.worldedit

import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit

/** A change of a robot, and how to take it back when other things have changed since. */
internal interface RobotChange {
    /** Makes the change; null if [world] does not have the robot. */
    fun editOf(world: World): WorldEdit?

    /** Takes back the change and nothing else; null if [world] does not have it any more. */
    fun undoOf(world: World): WorldEdit?
}

/**
 * A whole robot replaced by another one. It is brought back where it stands then.
 *
 * @param before the robot before the change.
 * @param after how it is built then.
 */
internal class Replacement(private val before: RobotPlacement, private val after: RobotDescription) : RobotChange {
    override fun editOf(world: World): WorldEdit? = world.withRobot(before.name) {
        it.copy(description = after, draft = null)
    }

    override fun undoOf(world: World): WorldEdit? {
        val now = world.robots.find { it.name == before.name } ?: return null
        if (now.description != after || now.draft != null) return null
        return world.withRobot(before.name) { it.copy(description = before.description, draft = before.draft) }
    }
}

/** Changes the robot [name]; null if there is none. */
internal fun World.withRobot(name: String, change: (RobotPlacement) -> RobotPlacement): WorldEdit? {
    val (index, robot) = robots.withIndex().find { it.value.name == name } ?: return null
    return WorldEdit.Change(ElementRef(ElementKind.ROBOT, index), Element.OfRobot(change(robot)))
}
