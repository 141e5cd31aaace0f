package robotran.ui.parts

import androidx.compose.runtime.Composable
import robotran.editing.READY_ROBOT_WORDS
import robotran.editing.RobotTexts
import robotran.uikit.*
import robotran.world.ReadyRobots

/** The name of the ready robot with the key [base] of [ReadyRobots.all]. */
@Composable
fun readyRobotName(base: String): String = READY_ROBOT_WORDS.getValue(base)(spoken)

/** The same; where the name does not tell the brick, it is added. */
@Composable
fun readyRobotWithBrick(base: String): String {
    val name = readyRobotName(base)
    val brick = ReadyRobots.all.getValue(base).brick.label
    return if (brick in name) name else RobotTexts.readyWithBrick(spoken, name, brick)
}
