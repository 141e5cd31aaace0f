package robotran.ui.parts

import androidx.compose.runtime.Composable
import robotran.ui.texts.RobotTexts
import robotran.uikit.*
import robotran.world.ReadyRobots

/** The name of the ready robot with the key [base] of [ReadyRobots.all]. */
@Composable
internal fun readyRobotName(base: String): String = READY_ROBOT_WORDS.getValue(base)(spoken)

/** The same; where the name does not tell the brick, it is added. */
@Composable
internal fun readyRobotWithBrick(base: String): String {
    val name = readyRobotName(base)
    val brick = ReadyRobots.all.getValue(base).brick.label
    return if (brick in name) name else RobotTexts.readyWithBrick(spoken, name, brick)
}

internal val READY_ROBOT_WORDS: Map<String, Label> = mapOf(
    "rcx-penbot" to RobotTexts::readyRcxPenbot,
    "nxt-penbot" to RobotTexts::readyNxtPenbot,
    "line-follower" to RobotTexts::readyLineFollower,
    "sumo" to RobotTexts::readySumo,
    "both-sides" to RobotTexts::readyBothSides,
)
