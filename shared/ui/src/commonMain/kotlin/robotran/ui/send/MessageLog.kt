package robotran.ui.send

import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.send_bytes
import robotran.ui.resources.send_message
import robotran.ui.runbar.oneDecimal
import robotran.ui.theme.LocalRobotranColours
import robotran.workshop.state.RobotMessage

/** What the robot has sent, the newest first. */
@Composable
internal fun MessageLog(messages: List<RobotMessage>) {
    val colours = LocalRobotranColours.current
    for (message in messages.asReversed()) {
        key(message.number) {
            Text(textOf(message), Modifier.testTag("send-message"), color = colours.onPane, fontSize = 16.sp)
        }
    }
}

@Composable
private fun textOf(message: RobotMessage): String {
    val time = oneDecimal(message.milliseconds / 1_000.0)
    val bytes = message.bytes
    return if (bytes.size == 2 && bytes[0] and TOGGLE.inv() == MESSAGE) {
        stringResource(Res.string.send_message, time, bytes[1])
    } else {
        stringResource(Res.string.send_bytes, time, bytes.joinToString(" "))
    }
}

/** The opcode of a message between bricks, without the toggle bit that each opcode has. */
private const val MESSAGE = 0xF7
private const val TOGGLE = 0x08
