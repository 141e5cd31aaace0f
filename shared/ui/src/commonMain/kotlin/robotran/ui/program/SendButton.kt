package robotran.ui.program

import androidx.compose.runtime.Composable
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.RoundButton
import robotran.ui.parts.SignPicture
import robotran.ui.parts.StrokeIcons
import robotran.ui.resources.Res
import robotran.ui.resources.send_robot
import robotran.ui.theme.LocalRobotranColours

/**
 * Sends the shown program to a real robot.
 *
 * @param hasRoom whether there is room for its words.
 */
@Composable
internal fun SendButton(hasRoom: Boolean, onClick: () -> Unit) {
    val words = stringResource(Res.string.send_robot)
    if (hasRoom) {
        val colour = LocalRobotranColours.current.onPane
        PaneChip(words, "send-robot", on = false, { SignPicture(StrokeIcons.SEND, colour, SIGN) }, onClick = onClick)
    } else {
        RoundButton(StrokeIcons.SEND, words, "send-robot", SIGN, onClick = onClick)
    }
}

private val SIGN = 16.dp
