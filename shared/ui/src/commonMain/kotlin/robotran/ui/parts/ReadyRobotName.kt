package robotran.ui.parts

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*
import robotran.world.ReadyRobots

/** The name of the ready robot with the key [base] of [ReadyRobots.all]. */
@Composable
internal fun readyRobotName(base: String): String = stringResource(READY_ROBOT_WORDS.getValue(base))

/** The same; where the name does not tell the brick, it is added. */
@Composable
internal fun readyRobotWithBrick(base: String): String {
    val name = readyRobotName(base)
    val brick = ReadyRobots.all.getValue(base).brick.name
    return if (brick in name) name else stringResource(Res.string.robot_ready_with_brick, name, brick)
}

internal val READY_ROBOT_WORDS: Map<String, StringResource> = mapOf(
    "rcx-penbot" to Res.string.robot_ready_rcx_penbot,
    "nxt-penbot" to Res.string.robot_ready_nxt_penbot,
    "line-follower" to Res.string.robot_ready_line_follower,
    "sumo" to Res.string.robot_ready_sumo,
    "both-sides" to Res.string.robot_ready_both_sides,
)
