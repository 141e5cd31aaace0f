package robotran.world.robot

import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.World

/**
 * Why a robot that is still being built ([RobotPlacement.draft]) is impossible so far.
 *
 * @property number the index of the robot in its world.
 * @property name the name of the robot.
 * @property draft what it is to be.
 * @property error the first error of [draft].
 */
data class DraftError(val number: Int, val name: String, val draft: RobotDescription, val error: RobotError)

/** The error of the first robot of [world] that is an impossible draft; null if there is none. */
fun draftError(world: World): DraftError? = world.robots.indices.firstNotNullOfOrNull { draftError(world, it) }

/** The same for the robot with the index [number]; null, too, if [world] has no such robot. */
fun draftError(world: World, number: Int): DraftError? {
    val robot = world.robots.getOrNull(number) ?: return null
    val draft = robot.draft ?: return null
    return robotErrors(draft).firstOrNull()?.let { DraftError(number, robot.name, draft, it) }
}
