package robotran.ui.send.microbit

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.microbitlink.BoardError
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.HubSendTexts
import robotran.ui.school.texts.MicrobitSendTexts
import robotran.ui.school.texts.SendTexts
import robotran.ui.send.CancelButton
import robotran.uikit.*
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.state.MicrobitSendState
import robotran.workshop.state.MicrobitSendStep

/** The button that cancels or closes, and the actions of the step of [state]. */
@Composable
internal fun MicrobitSendButtons(
    state: MicrobitSendState,
    onEvent: (MicrobitSendEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    val actions = actionsOf(state)
    ButtonRows(modifier) {
        CancelButton(state.step.isBusy) { onEvent(MicrobitSendEvent.Cancelled) }
        actions.forEachIndexed { index, action ->
            val kind = if (index == actions.lastIndex) ButtonKind.DIALOG_MAIN else ButtonKind.DIALOG_OTHER
            Button(action.words(spoken), action.tag, kind) { onEvent(action.event) }
        }
    }
}

/** What can be done in the step of [state], the most likely last. */
private fun actionsOf(state: MicrobitSendState): List<MicrobitAction> = when (val step = state.step) {
    MicrobitSendStep.Building, MicrobitSendStep.CompilerFailed, is MicrobitSendStep.Choosing -> emptyList()
    MicrobitSendStep.Looking, MicrobitSendStep.Connecting -> emptyList()
    is MicrobitSendStep.Sending, MicrobitSendStep.Copying -> emptyList()
    is MicrobitSendStep.HasErrors -> listOf(MicrobitAction.SHOW_MISTAKE)
    is MicrobitSendStep.ManyBoards -> listOf(MicrobitAction.BACK)

    MicrobitSendStep.Found -> if (state.board?.expected == null) {
        val hasWhole = state.board?.board in state.microPython?.versions.orEmpty()
        listOfNotNull(MicrobitAction.SEND_WHOLE.takeIf { hasWhole }, MicrobitAction.SEND)
    } else {
        listOf(MicrobitAction.SEND, MicrobitAction.OTHER_BOARD)
    }

    is MicrobitSendStep.Cancelled -> listOf(MicrobitAction.BACK, MicrobitAction.SEND_AGAIN)

    is MicrobitSendStep.Running ->
        listOf(if (step.errorLine == null) MicrobitAction.BACK else MicrobitAction.SHOW_LINE, MicrobitAction.SEND_AGAIN)

    MicrobitSendStep.Copied, is MicrobitSendStep.HexSaved, is MicrobitSendStep.PythonSaved -> listOf(
        MicrobitAction.BACK,
    )
    is MicrobitSendStep.NotCopied -> listOf(MicrobitAction.BACK, MicrobitAction.COPY_AGAIN)
    is MicrobitSendStep.Failed -> actionsOf(step, hasMicroPython = state.microPython != null)
}

private fun actionsOf(step: MicrobitSendStep.Failed, hasMicroPython: Boolean): List<MicrobitAction> = when {
    step.canSendWhole -> listOf(MicrobitAction.AGAIN, MicrobitAction.SEND_WHOLE)

    step.error == BoardError.NoPython && !hasMicroPython ->
        listOf(MicrobitAction.BACK, MicrobitAction.OPEN_MICROPYTHON)

    step.error == BoardError.NotAMicrobit -> listOf(MicrobitAction.BACK, MicrobitAction.OTHER_BOARD)
    step.error in ENDS || step.error is BoardError.BadFile -> listOf(MicrobitAction.BACK)
    else -> listOf(MicrobitAction.BACK, MicrobitAction.AGAIN)
}

/** Errors that another try does not mend. */
private val ENDS = setOf(BoardError.NotAllowed, BoardError.InterfaceTooOld)

private enum class MicrobitAction(val words: Label, val tag: String, val event: MicrobitSendEvent) {
    AGAIN(SendTexts::again, SendTags.SEND_AGAIN, MicrobitSendEvent.Retried),
    SEND_AGAIN(SendTexts::againAfter, SendTags.SEND_AGAIN, MicrobitSendEvent.Retried),
    COPY_AGAIN(SendTexts::again, SendTags.SEND_AGAIN, MicrobitSendEvent.DriveRequested),
    BACK(MicrobitSendTexts::back, SendTags.SEND_BACK, MicrobitSendEvent.BackRequested),
    OPEN_MICROPYTHON(
        MicrobitSendTexts::openMicroPython,
        SendTags.SEND_CHOOSE_MICROPYTHON,
        MicrobitSendEvent.MicroPythonRequested,
    ),
    OTHER_BOARD(MicrobitSendTexts::otherBoard, SendTags.SEND_CHOOSE_BOARD, MicrobitSendEvent.OtherBoardRequested),
    SEND(HubSendTexts::send, SendTags.SEND_CONFIRM, MicrobitSendEvent.Confirmed),
    SEND_WHOLE(MicrobitSendTexts::sendWhole, SendTags.SEND_WHOLE, MicrobitSendEvent.WholeRequested),
    SHOW_MISTAKE(SendTexts::mistakeShow, SendTags.SEND_SHOW_MISTAKE, MicrobitSendEvent.LineShown),
    SHOW_LINE(HubSendTexts::showLine, SendTags.SEND_SHOW_LINE, MicrobitSendEvent.LineShown),
}
