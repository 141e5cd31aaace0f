package robotran.ui.export

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.window.DialogProperties
import robotran.simulation.state.SessionState
import robotran.ui.texts.ExportTexts
import robotran.uikit.*
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.ExportState
import robotran.workshop.state.ShowStep
import robotran.world.World

/** The sheet with which pupils show what they made. While something is made, a touch outside does not close it. */
@Composable
internal fun ExportDialog(state: ExportState, world: World, session: SessionState, onEvent: (WorkshopEvent) -> Unit) =
    AppDialog(
        { onEvent(ExportEvent.Closed) },
        // The default width would be too narrow for a phone on its side.
        DialogProperties(dismissOnClickOutside = state.step !is ShowStep.Making, usePlatformDefaultWidth = false),
    ) { ShowCard(state, world, session, onEvent, Modifier.padding(MARGIN)) }

/** The sheet without its window. It has one size for all steps, so its buttons stay where they are. */
@Composable
internal fun ShowCard(
    state: ExportState,
    world: World,
    session: SessionState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    val colours = LocalRobotranColours.current
    val title = ExportTexts.title(spoken)
    val scale = LocalDensity.current.fontScale
    Surface(
        modifier
            .size(WIDTH * minOf(scale, MAX_WIDENING), HEIGHT * scale)
            .testTag("show-sheet")
            .semantics { paneTitle = title },
        Shapes.SHEET,
    ) {
        Column(Modifier.padding(20.dp), Arrangement.spacedBy(12.dp)) {
            Text(title, Modifier.semantics { heading() }, TextStyles.dialogTitle)
            Box(Modifier.weight(1f).fillMaxWidth()) {
                when (val step = state.step) {
                    ShowStep.Choosing -> ExportChoices(state, world, session, onEvent)
                    is ShowStep.ChoosingSpeed -> SpeedChoice(step, onEvent)
                    is ShowStep.Making -> MakingView(step)
                    is ShowStep.ChoosingPoster -> PosterForm(step, onEvent)
                    is ShowStep.Saved -> SavedView(step.name)
                    is ShowStep.Failed -> FailedView(step.error)
                }
            }
            ExportButtons(state, onEvent, Modifier.fillMaxWidth())
        }
    }
}

private val MARGIN = 16.dp
private val WIDTH = 680.dp

/** With large text the sheet becomes wider up to here; beyond, its lines would be too long. */
private const val MAX_WIDENING = 1.4f

/** Enough for all choices with text of the usual size. */
private val HEIGHT = 560.dp
