package robotran.ui.program

import androidx.compose.runtime.Composable
import androidx.compose.ui.unit.dp
import robotran.ui.common.tags.CommonTags
import robotran.uikit.*

/**
 * Sends the shown program to a real robot, or, for a brick to which Robotran cannot send, saves a kit for it.
 *
 * @param label the name of the button.
 * @param hasRoom whether there is room for its words.
 */
@Composable
internal fun SendButton(label: Label, hasRoom: Boolean, onClick: () -> Unit) =
    SendButton(label(spoken), hasRoom, onClick)

@Composable
private fun SendButton(label: String, hasRoom: Boolean, onClick: () -> Unit) {
    if (hasRoom) {
        val colour = LocalRobotranColours.current.onPane
        PaneChip(label, CommonTags.SEND_ROBOT, on = false, {
            IconView(
                ThinIcons.SEND,
                colour,
                size = SIGN,
            )
        }, onClick = onClick)
    } else {
        IconButton(ThinIcons.SEND, label, CommonTags.SEND_ROBOT, IconButtonKind.TOOL, onClick = onClick)
    }
}

private val SIGN = 16.dp
