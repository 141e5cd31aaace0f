package robotran.ui.send

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.tower.TowerError
import robotran.tower.port.OpenFailure
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.SendTexts
import robotran.uikit.*
import robotran.workshop.event.SendEvent
import robotran.workshop.state.SendError
import robotran.workshop.state.SendStep

/** The button that cancels or closes, and the actions of [step]. */
@Composable
internal fun SendButtons(step: SendStep, onEvent: (SendEvent) -> Unit, modifier: Modifier = Modifier) {
    val actions = actionsOf(step)
    // A slot is chosen by its own button, so what else can be done is not the main thing.
    val main = actions.lastOrNull()?.takeIf { step !is SendStep.ChoosingSlot }
    ButtonRows(modifier) {
        CancelButton(step.isBusy) { onEvent(SendEvent.Cancelled) }
        for (action in actions.filter { it != main }) {
            Button(action.words(spoken), action.tag, ButtonKind.DIALOG_OTHER) { onEvent(action.event) }
        }
        if (main != null) Button(main.words(spoken), main.tag, ButtonKind.DIALOG_MAIN) { onEvent(main.event) }
    }
}

@Composable
internal fun CancelButton(cancels: Boolean, onClick: () -> Unit) =
    ButtonFrame(SendTags.SEND_CANCEL, ButtonKind.DIALOG_OTHER, onClick = onClick) {
        val words = if (cancels) SendTexts::cancel else SendTexts::close
        SteadySize(words, listOf(SendTexts::cancel, SendTexts::close)) { Text(it(spoken), style = TextStyles.body) }
    }

/** What can be done in [step], the most likely last. */
private fun actionsOf(step: SendStep): List<SendAction> = when (step) {
    SendStep.Building, SendStep.Checking, SendStep.NoTowers, SendStep.CompilerFailed -> emptyList()
    is SendStep.Sending, is SendStep.ChoosingTower, is SendStep.Watching, is SendStep.ReadingDatalog -> emptyList()
    is SendStep.ChoosingSlot -> listOf(SendAction.READ_DATALOG)

    is SendStep.Datalog -> when {
        step.entries.isEmpty() -> listOf(SendAction.TO_SLOTS)
        step.savedAs != null -> listOf(SendAction.SAVE_DATALOG, SendAction.TO_SLOTS)
        else -> listOf(SendAction.TO_SLOTS, SendAction.SAVE_DATALOG)
    }

    is SendStep.HasErrors -> listOf(SendAction.SHOW_MISTAKE)
    SendStep.NoCompiler -> listOf(SendAction.AGAIN)

    is SendStep.NeedsFirmware -> when {
        step.usable != null -> listOf(SendAction.OTHER_FILE, SendAction.SEND_FIRMWARE)
        else -> listOf(SendAction.CHOOSE_FILE)
    }

    is SendStep.Cancelled -> listOf(SendAction.SEND_AGAIN)
    is SendStep.Done -> listOf(SendAction.WATCH)
    is SendStep.Failed -> actionsOf(step.error)
}

private fun actionsOf(error: SendError): List<SendAction> = when (error) {
    // A tower that was refused is asked for by choosing it again.
    is SendError.OfPort -> listOf(SendAction.AGAIN, SendAction.OTHER_TOWER).let {
        if (error.failure == OpenFailure.NOT_ALLOWED) it else it.asReversed()
    }

    is SendError.OfTower -> when (val cause = error.error) {
        is TowerError.TooLarge -> if (cause.isOfSlots) listOf(SendAction.EMPTY_SLOTS) else emptyList()
        TowerError.FirmwareRefused -> listOf(SendAction.CHOOSE_FILE)
        else -> listOf(SendAction.OTHER_TOWER, SendAction.AGAIN)
    }
}

/** LEGO's firmware does not tell its room, which all slots share. */
private val TowerError.TooLarge.isOfSlots get() = maxBytes == null

private enum class SendAction(val words: Label, val tag: String, val event: SendEvent) {
    AGAIN(SendTexts::again, SendTags.SEND_AGAIN, SendEvent.Retried),
    SEND_AGAIN(SendTexts::againAfter, SendTags.SEND_AGAIN, SendEvent.Retried),
    OTHER_TOWER(SendTexts::otherTower, SendTags.SEND_OTHER_TOWER, SendEvent.OtherTowerRequested),
    SHOW_MISTAKE(SendTexts::mistakeShow, SendTags.SEND_SHOW_MISTAKE, SendEvent.DiagnosticShown),
    CHOOSE_FILE(SendTexts::firmwareChoose, SendTags.SEND_CHOOSE_FIRMWARE, SendEvent.FirmwareFileRequested),
    OTHER_FILE(SendTexts::firmwareOther, SendTags.SEND_CHOOSE_FIRMWARE, SendEvent.FirmwareFileRequested),
    SEND_FIRMWARE(SendTexts::firmwareSend, SendTags.SEND_FIRMWARE, SendEvent.FirmwareConfirmed),
    EMPTY_SLOTS(SendTexts::emptySlots, SendTags.SEND_EMPTY_SLOTS, SendEvent.SlotsEmptied),
    READ_DATALOG(SendTexts::datalogRead, SendTags.SEND_READ_DATALOG, SendEvent.DatalogRequested),
    SAVE_DATALOG(SendTexts::datalogSave, SendTags.SEND_SAVE_DATALOG, SendEvent.DatalogSaved),
    TO_SLOTS(SendTexts::toSlots, SendTags.SEND_TO_SLOTS, SendEvent.Retried),
    WATCH(SendTexts::watch, SendTags.SEND_WATCH, SendEvent.WatchingRequested),
}
