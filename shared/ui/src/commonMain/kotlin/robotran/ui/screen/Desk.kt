package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import robotran.simulation.SessionInput
import robotran.ui.brick.BrickFront
import robotran.ui.brick.BrickHint
import robotran.ui.brick.BrickStrip
import robotran.ui.drawer.TaskAndGoals
import robotran.ui.theme.LocalRobotranColours
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.WorkshopState

/**
 * Paper and brick on screens with room for both. The paper gets all space that the brick leaves, and no control ever
 * moves.
 */
@Composable
internal fun Desk(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    BoxWithConstraints(modifier.fillMaxWidth().background(LocalRobotranColours.current.desk)) {
        val scale = LocalDensity.current.fontScale.coerceAtLeast(1f)
        val plan = PaneLayout.of(maxWidth, maxHeight, scale, state.hasTask || state.session.goals.isNotEmpty())
        if (plan.place == BrickPlacement.STRIP_BELOW) {
            Column(Modifier.fillMaxSize()) {
                CoveredSheet(state, onEvent, Modifier.weight(1f))
                ChipAndStrip(state, onEvent)
            }
        } else {
            Row(Modifier.fillMaxSize()) {
                CoveredSheet(state, onEvent, Modifier.weight(1f).fillMaxHeight(), withHint = !plan.hintBeside)
                Column(
                    Modifier
                        .width(plan.brickWidth + PaneLayout.MARGIN)
                        .fillMaxHeight()
                        .padding(end = PaneLayout.MARGIN, bottom = PaneLayout.MARGIN),
                    Arrangement.spacedBy(PaneLayout.MARGIN),
                ) {
                    Box(Modifier.weight(1f).fillMaxWidth(), Alignment.BottomStart) {
                        if (plan.hintBeside) BrickHint(state.run.brick, Modifier.padding(top = PaneLayout.MARGIN))
                    }
                    TaskAndGoals(state.hasTask, state.taskShown, state.session.goals, onEvent, isSlim = state.hasTask)
                    if (plan.place == BrickPlacement.BESIDE) {
                        WholeBrick(state.run, onEvent, Modifier.width(plan.brickWidth))
                    } else {
                        Strip(state.run, onEvent)
                    }
                }
            }
        }
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun ChipAndStrip(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit) {
    FlowRow(
        Modifier.fillMaxWidth().padding(horizontal = PaneLayout.MARGIN).padding(bottom = PaneLayout.MARGIN),
        Arrangement.spacedBy(PaneLayout.MARGIN, Alignment.End),
        Arrangement.spacedBy(PaneLayout.MARGIN),
    ) {
        TaskAndGoals(
            state.hasTask,
            state.taskShown,
            state.session.goals,
            onEvent,
            Modifier.align(Alignment.CenterVertically),
        )
        Strip(state.run, onEvent)
    }
}

/** The brick with all its buttons and ports. */
@Composable
internal fun WholeBrick(run: RunPaneState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) =
    BrickFront(
        run.brick,
        run.down,
        { onEvent(RunEvent.ButtonPressed(it)) },
        { onEvent(RunEvent.ButtonReleased(it)) },
        modifier,
        run.world.robots[run.watched].ports,
        { port, pressed ->
            onEvent(RunEvent.SessionTouched(SessionInput.TouchSensor(run.watched, port, pressed)))
        },
    )

/** The brick's display and Run. */
@Composable
internal fun Strip(run: RunPaneState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) = BrickStrip(
    run.brick,
    run.down,
    { onEvent(RunEvent.ButtonPressed(it)) },
    { onEvent(RunEvent.ButtonReleased(it)) },
    modifier,
)
