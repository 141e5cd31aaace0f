package robotran.ui.send

import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.tower.ReceivedMessage
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.SendTexts
import robotran.uikit.*
import robotran.workshop.state.RobotMessage

/** What the robot has sent, the newest first. */
@Composable
internal fun MessageLog(messages: List<RobotMessage>) {
    for (message in messages.asReversed()) {
        key(message.number) {
            Text(textOf(message), Modifier.testTag(SendTags.SEND_MESSAGE), TextStyles.body)
        }
    }
}

@Composable
private fun textOf(message: RobotMessage): String {
    val time = oneDecimal(message.milliseconds / 1_000.0)
    return when (val received = message.received) {
        is ReceivedMessage.Number -> SendTexts.message(spoken, time, received.value)
        is ReceivedMessage.Packet -> SendTexts.bytes(spoken, time, decimal(received.bytes))
        is ReceivedMessage.Raw -> SendTexts.bytes(spoken, time, decimal(received.bytes))
    }
}

private fun decimal(bytes: List<Byte>) = bytes.joinToString(" ") { (it.toInt() and 0xFF).toString() }
