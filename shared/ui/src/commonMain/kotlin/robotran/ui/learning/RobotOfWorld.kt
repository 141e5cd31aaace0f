package robotran.ui.learning

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.learning_robot_both_sides
import robotran.ui.resources.learning_robot_line_follower
import robotran.ui.resources.learning_robot_nxt_penbot
import robotran.ui.resources.learning_robot_own
import robotran.ui.resources.learning_robot_rcx_penbot
import robotran.ui.resources.learning_robot_sumo
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.World

/** Which robot the pupil has in [world]. */
@Composable
internal fun robotOf(world: World): String {
    val robot = world.robots.first().description
    val name = readyName(robot) ?: return stringResource(Res.string.learning_robot_own, robot.brick.name)
    return stringResource(name)
}

/** The name of [robot] for people; in the pupil's language, if it is a ready one. */
@Composable
internal fun robotTitle(robot: RobotDescription): String = readyName(robot)?.let { stringResource(it) } ?: robot.title

/** The name of the ready robot that [robot] is, whatever is plugged into a penbot with an RCX; null for any other. */
private fun readyName(robot: RobotDescription): StringResource? = when (robot.copy(parts = emptyList())) {
    ReadyRobots.RCX_PENBOT.copy(parts = emptyList()) -> Res.string.learning_robot_rcx_penbot

    else -> when (robot) {
        ReadyRobots.NXT_PENBOT -> Res.string.learning_robot_nxt_penbot
        ReadyRobots.LINE_FOLLOWER -> Res.string.learning_robot_line_follower
        ReadyRobots.SUMO -> Res.string.learning_robot_sumo
        ReadyRobots.BOTH_SIDES -> Res.string.learning_robot_both_sides
        else -> null
    }
}
