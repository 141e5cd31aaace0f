package robotran.ui.world

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.centimetres
import robotran.ui.resources.degrees
import robotran.ui.resources.ink_length
import robotran.ui.resources.robot_pen_down
import robotran.ui.resources.robot_pen_up
import robotran.ui.resources.robot_pose
import robotran.ui.runbar.oneDecimal
import robotran.world.SessionState

/** Where the robot is and what it has drawn, in words. */
@Composable
internal fun describeWorld(session: SessionState): String {
    val pose = session.robot.pose
    val place = stringResource(
        Res.string.robot_pose,
        stringResource(Res.string.centimetres, oneDecimal(pose.x)),
        stringResource(Res.string.centimetres, oneDecimal(pose.y)),
        stringResource(Res.string.degrees, oneDecimal(pose.heading)),
    )
    val pen = stringResource(if (session.robot.penDown) Res.string.robot_pen_down else Res.string.robot_pen_up)
    val ink = stringResource(Res.string.ink_length, stringResource(Res.string.centimetres, oneDecimal(session.ink.lengthCentimetres)))
    return "$place, $pen, $ink"
}
