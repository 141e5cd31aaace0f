package robotran.ui.send.hub

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.hublink.HubError
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.HubSendTexts
import robotran.ui.school.texts.SendTexts
import robotran.ui.send.CancelButton
import robotran.uikit.*
import robotran.workshop.event.HubSendEvent
import robotran.workshop.state.HubSendState
import robotran.workshop.state.HubSendStep

/** The button that cancels or closes, and the actions of the step of [state]. */
@Composable
internal fun HubSendButtons(state: HubSendState, onEvent: (HubSendEvent) -> Unit, modifier: Modifier = Modifier) {
    val actions = actionsOf(state)
    ButtonRows(modifier) {
        CancelButton(state.step.isBusy) { onEvent(HubSendEvent.Cancelled) }
        actions.forEachIndexed { index, action ->
            val kind = if (index == actions.lastIndex) ButtonKind.DIALOG_MAIN else ButtonKind.DIALOG_OTHER
            Button(action.words(spoken), action.tag, kind) { onEvent(action.event) }
        }
    }
}

/** What can be done in the step of [state], the most likely last. */
private fun actionsOf(state: HubSendState): List<HubAction> = when (val step = state.step) {
    HubSendStep.Building, HubSendStep.Connecting, HubSendStep.CompilerFailed -> emptyList()
    HubSendStep.Looking, is HubSendStep.Choosing, is HubSendStep.Sending -> emptyList()
    is HubSendStep.HasErrors -> listOf(HubAction.SHOW_MISTAKE)
    HubSendStep.NoCompiler -> listOf(HubAction.AGAIN)
    is HubSendStep.NoWay -> listOf(HubAction.SAVE_PYTHON)

    HubSendStep.Found -> when (state.hub?.expected) {
        null -> listOf(HubAction.OTHER_HUB, HubAction.SEND)
        else -> listOf(HubAction.SEND, HubAction.OTHER_HUB)
    }

    HubSendStep.Cancelled -> listOf(HubAction.SEND_AGAIN)
    is HubSendStep.Ready -> if (step.isGone) emptyList() else listOf(HubAction.OTHER_HUB, HubAction.START)
    is HubSendStep.Running -> if (step.isStopping) emptyList() else listOf(HubAction.STOP)

    is HubSendStep.Ended -> listOfNotNull(
        HubAction.SHOW_LINE.takeIf { step.console.error?.line != null },
        if (step.isGone) HubAction.SEND_AGAIN else HubAction.START,
    )

    is HubSendStep.Failed -> actionsOf(step.error)
}

private fun actionsOf(error: HubError): List<HubAction> = when (error) {
    is HubError.NumberTooLarge, HubError.NotAProgram -> emptyList()
    is HubError.TooLarge, HubError.LegoFirmware, is HubError.TooOld -> listOf(HubAction.AGAIN, HubAction.OTHER_HUB)
    else -> listOf(HubAction.OTHER_HUB, HubAction.AGAIN)
}

private enum class HubAction(val words: Label, val tag: String, val event: HubSendEvent) {
    AGAIN(SendTexts::again, SendTags.SEND_AGAIN, HubSendEvent.Retried),
    SEND_AGAIN(SendTexts::againAfter, SendTags.SEND_AGAIN, HubSendEvent.Retried),
    OTHER_HUB(HubSendTexts::otherHub, SendTags.SEND_OTHER_HUB, HubSendEvent.OtherHubRequested),
    SEND(HubSendTexts::send, SendTags.SEND_CONFIRM, HubSendEvent.Confirmed),
    SHOW_MISTAKE(SendTexts::mistakeShow, SendTags.SEND_SHOW_MISTAKE, HubSendEvent.LineShown),
    SHOW_LINE(HubSendTexts::showLine, SendTags.SEND_SHOW_LINE, HubSendEvent.LineShown),
    SAVE_PYTHON(HubSendTexts::savePython, SendTags.SEND_SAVE_PYTHON, HubSendEvent.PythonSaved),
    START(HubSendTexts::start, SendTags.SEND_START, HubSendEvent.Started),
    STOP(HubSendTexts::stop, SendTags.SEND_STOP, HubSendEvent.Stopped),
}
