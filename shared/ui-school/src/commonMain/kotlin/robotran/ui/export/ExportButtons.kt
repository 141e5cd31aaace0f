package robotran.ui.export

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.ui.school.tags.ExportTags
import robotran.ui.school.texts.ExportTexts
import robotran.uikit.*
import robotran.workshop.event.ExportEvent
import robotran.workshop.state.ExportState
import robotran.workshop.state.MadePicture
import robotran.workshop.state.ShowStep

/** The buttons of the step: at the left the one that leaves it, at the right what goes on. */
@Composable
internal fun ExportButtons(state: ExportState, onEvent: (ExportEvent) -> Unit, modifier: Modifier = Modifier) {
    val (first, others) = actionsOf(state)
    ButtonRows(modifier) {
        Button(first.words(spoken), first.tag, ButtonKind.DIALOG_OTHER) { onEvent(first.event) }
        for (action in others.dropLast(1)) {
            Button(action.words(spoken), action.tag, ButtonKind.DIALOG_OTHER) {
                onEvent(action.event)
            }
        }
        others.lastOrNull()?.let { main ->
            Button(main.words(spoken), main.tag, ButtonKind.DIALOG_MAIN) { onEvent(main.event) }
        }
    }
}

private fun actionsOf(state: ExportState): Pair<ShowAction, List<ShowAction>> = when (val step = state.step) {
    ShowStep.Choosing -> ShowAction.CLOSE to emptyList()
    is ShowStep.ChoosingSpeed, is ShowStep.ChoosingPoster -> ShowAction.BACK to listOf(ShowAction.MAKE)
    is ShowStep.Making -> ShowAction.CANCEL to emptyList()

    is ShowStep.Made -> ShowAction.MORE to listOfNotNull(
        ShowAction.PRINT.takeIf { state.canPrint && step.work.shown is MadePicture.Page },
        ShowAction.SHARE.takeIf { state.canShare },
        ShowAction.SAVE,
        ShowAction.CLOSE.takeIf { step.savedAs != null },
    )

    is ShowStep.Failed -> ShowAction.MORE to listOf(ShowAction.CLOSE)
}

private enum class ShowAction(val words: Label, val tag: String, val event: ExportEvent) {
    CLOSE(ExportTexts::close, ExportTags.SHOW_CLOSE, ExportEvent.Closed),
    BACK(ExportTexts::back, ExportTags.SHOW_BACK, ExportEvent.BackRequested),
    CANCEL(ExportTexts::cancel, ExportTags.SHOW_CANCEL, ExportEvent.BackRequested),
    MORE(ExportTexts::more, ExportTags.SHOW_MORE, ExportEvent.BackRequested),
    MAKE(ExportTexts::make, ExportTags.SHOW_MAKE, ExportEvent.MakingRequested),
    SAVE(ExportTexts::save, ExportTags.SHOW_SAVE, ExportEvent.SaveRequested),
    SHARE(ExportTexts::share, ExportTags.SHOW_SHARE, ExportEvent.ShareRequested),
    PRINT(ExportTexts::posterPrint, ExportTags.SHOW_PRINT, ExportEvent.PrintRequested),
}
