package robotran.ui.show

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.documents.MainButton
import robotran.ui.documents.OtherButton
import robotran.ui.parts.ButtonRows
import robotran.ui.resources.*
import robotran.workshop.event.ShowEvent
import robotran.workshop.state.ShowState
import robotran.workshop.state.ShowStep

/** The buttons of the step: at the left the one that leaves it, at the right what goes on. */
@Composable
internal fun ShowButtons(state: ShowState, onEvent: (ShowEvent) -> Unit, modifier: Modifier = Modifier) {
    val (first, others) = actionsOf(state)
    ButtonRows(modifier) {
        OtherButton(stringResource(first.words), first.tag) { onEvent(first.event) }
        for (action in others.dropLast(1)) {
            OtherButton(stringResource(action.words), action.tag) {
                onEvent(action.event)
            }
        }
        others.lastOrNull()?.let { main ->
            MainButton(stringResource(main.words), main.tag) { onEvent(main.event) }
        }
    }
}

private fun actionsOf(state: ShowState): Pair<ShowAction, List<ShowAction>> = when (state.step) {
    ShowStep.Choosing -> ShowAction.CLOSE to emptyList()
    is ShowStep.ChoosingSpeed -> ShowAction.BACK to listOf(ShowAction.MAKE)
    is ShowStep.Making -> ShowAction.CANCEL to emptyList()

    is ShowStep.ChoosingPoster -> {
        ShowAction.BACK to listOf(ShowAction.SAVE, ShowAction.PRINT).filter { it != ShowAction.PRINT || state.canPrint }
    }

    is ShowStep.Saved, is ShowStep.Failed -> ShowAction.MORE to listOf(ShowAction.CLOSE)
}

private enum class ShowAction(val words: StringResource, val tag: String, val event: ShowEvent) {
    CLOSE(Res.string.show_close, "show-close", ShowEvent.Closed),
    BACK(Res.string.show_back, "show-back", ShowEvent.BackRequested),
    CANCEL(Res.string.show_cancel, "show-cancel", ShowEvent.BackRequested),
    MORE(Res.string.show_more, "show-more", ShowEvent.BackRequested),
    MAKE(Res.string.show_make, "show-make", ShowEvent.MakingRequested),
    SAVE(Res.string.show_poster_save, "poster-save", ShowEvent.PosterSaved),
    PRINT(Res.string.show_poster_print, "poster-print", ShowEvent.PosterPrinted),
}
