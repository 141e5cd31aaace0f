package robotran.ui.learning

import androidx.compose.runtime.Composable
import robotran.editing.RobotTexts
import robotran.ui.parts.readyRobotName
import robotran.ui.parts.readyRobotWithBrick
import robotran.uikit.*
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.World

/** Which robot the pupil has in [world]. */
@Composable
internal fun robotOf(world: World): String {
    val robot = world.robots.first().description
    return readyBase(robot)?.let { readyRobotWithBrick(it) } ?: RobotTexts.own(spoken, robot.brick.label)
}

/** The name of [robot] for people; in the pupil's language, if it is a ready one. */
@Composable
fun robotTitle(robot: RobotDescription): String = readyBase(robot)?.let { readyRobotName(it) } ?: robot.title

/** The ready robot that [robot] is, whatever is plugged into a penbot with an RCX; null for any other. */
private fun readyBase(robot: RobotDescription): String? {
    val penbot = ReadyRobots.RCX_PENBOT
    if (robot.copy(parts = penbot.parts) == penbot) return penbot.base
    return ReadyRobots.all.entries.firstOrNull { it.value == robot }?.key
}
