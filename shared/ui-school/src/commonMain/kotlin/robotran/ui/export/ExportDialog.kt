package robotran.ui.export

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.ui.school.tags.ExportTags
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.ExportState
import robotran.workshop.state.ShowStep
import robotran.world.World

/** The sheet with which pupils show what they made. While something is made, a touch outside does not close it. */
@Composable
fun ExportDialog(state: ExportState, world: World, session: SessionState, onEvent: (WorkshopEvent) -> Unit) =
    StepsDialog({ onEvent(ExportEvent.Closed) }, state.step !is ShowStep.Making) {
        ShowCard(state, world, session, onEvent, it)
    }

/** The sheet without its window. It has one size for all steps, so its buttons stay where they are. */
@Composable
internal fun ShowCard(
    state: ExportState,
    world: World,
    session: SessionState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
) = StepsCard(CommonTexts.showWork(spoken), ExportTags.SHOW_SHEET, SIZE, modifier) {
    Box(Modifier.weight(1f).fillMaxWidth()) {
        when (val step = state.step) {
            ShowStep.Choosing -> ExportChoices(state, world, session, onEvent)
            is ShowStep.ChoosingSpeed -> SpeedChoice(step, onEvent)
            is ShowStep.Making -> MakingView(step)
            is ShowStep.ChoosingPoster -> PosterForm(step, onEvent)
            is ShowStep.Made -> MadeView(step)
            is ShowStep.Failed -> FailedView(step.error)
        }
    }
    ExportButtons(state, onEvent, Modifier.fillMaxWidth())
}

/** Enough for all choices with text of the usual size. */
private val SIZE = DpSize(680.dp, 560.dp)
