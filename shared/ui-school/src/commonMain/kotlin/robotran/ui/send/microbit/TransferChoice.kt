package robotran.ui.send.microbit

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.HubSendTexts
import robotran.ui.school.texts.MicrobitSendTexts
import robotran.uikit.*
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.state.MicrobitSendStep
import robotran.workshop.state.MicrobitTransfer

/** A button for each way onto a board, the quickest first, and for the choice of MicroPython. */
@Composable
internal fun TransferChoice(
    step: MicrobitSendStep.Choosing,
    hasMicroPython: Boolean,
    onEvent: (MicrobitSendEvent) -> Unit,
) {
    for (choice in choicesOf(step, hasMicroPython)) {
        Button(choice.words(spoken), choice.tag, ButtonKind.DIALOG_ANSWER, Modifier.fillMaxWidth()) {
            onEvent(choice.event)
        }
    }
}

private fun choicesOf(step: MicrobitSendStep.Choosing, hasMicroPython: Boolean): List<Choice> = listOfNotNull(
    Choice.OPEN.takeIf { !hasMicroPython },
    Choice.USB.takeIf { MicrobitTransfer.USB in step.transfers },
    Choice.DRIVE.takeIf { MicrobitTransfer.DRIVE in step.transfers },
    Choice.SAVE_HEX.takeIf { MicrobitTransfer.SAVE in step.transfers },
    Choice.SAVE_PYTHON,
    Choice.OTHER.takeIf { hasMicroPython },
)

private enum class Choice(val words: Label, val tag: String, val event: MicrobitSendEvent) {
    OPEN(
        MicrobitSendTexts::openMicroPython,
        SendTags.SEND_CHOOSE_MICROPYTHON,
        MicrobitSendEvent.MicroPythonRequested,
    ),
    USB(MicrobitSendTexts::sendUsb, SendTags.SEND_USB, MicrobitSendEvent.UsbRequested),
    DRIVE(MicrobitSendTexts::copyToDrive, SendTags.SEND_DRIVE, MicrobitSendEvent.DriveRequested),
    SAVE_HEX(MicrobitSendTexts::saveHex, SendTags.SEND_SAVE_HEX, MicrobitSendEvent.HexSaved),
    SAVE_PYTHON(HubSendTexts::savePython, SendTags.SEND_SAVE_PYTHON, MicrobitSendEvent.PythonSaved),
    OTHER(
        MicrobitSendTexts::otherMicroPython,
        SendTags.SEND_CHOOSE_MICROPYTHON,
        MicrobitSendEvent.MicroPythonRequested,
    ),
}
