package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import robotran.simulation.SessionInput
import robotran.ui.brick.BrickFront
import robotran.ui.brick.BrickStrip
import robotran.ui.drawer.RunDrawer
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.WindowForm
import robotran.workshop.state.WorkshopState

/**
 * The pane of the world on screens with room for several panes: the paper, the open drawer, and a row with the tabs of
 * the drawer, task, goals and the small brick. The whole brick is beside the paper.
 *
 * @param maxDrawer the max height of the drawer.
 */
@Composable
internal fun WorldColumn(
    state: WorkshopState,
    form: WindowForm,
    onEvent: (WorkshopEvent) -> Unit,
    maxDrawer: Dp,
    modifier: Modifier = Modifier,
) {
    val isWhole = state.settings.panes[form].isBrickWhole ?: (form == WindowForm.BROAD)
    Column(modifier) {
        SheetAndBrick(state, isWhole, onEvent, {
            onEvent(SettingsEvent.BrickSizeChosen(form, true))
        }, Modifier.weight(1f))
        RunDrawer(state.run, onEvent, max = maxDrawer)
        WorldFooter(state, isWhole, onEvent) { onEvent(SettingsEvent.BrickSizeChosen(form, it)) }
    }
}

/**
 * Paper and, if it [isWhole], the brick. The paper gets all space that the brick and the messages leave, and no control
 * ever moves. Messages stand above the brick if there is room.
 */
@Composable
private fun SheetAndBrick(
    state: WorkshopState,
    isWhole: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
    onWholeBrick: () -> Unit,
    modifier: Modifier = Modifier,
) {
    BoxWithConstraints(modifier.fillMaxWidth().background(LocalRobotranColours.current.desk)) {
        val scale = LocalDensity.current.fontScale.coerceAtLeast(1f)
        val plan = PaneLayout.of(maxWidth, maxHeight, scale, isWhole)
        Row(Modifier.fillMaxSize()) {
            val options = MessageOptions(onWholeBrick = onWholeBrick.takeUnless { isWhole })
            SheetStage(
                state,
                onEvent,
                options.takeUnless { plan.messagesAbove },
                Modifier.weight(1f).fillMaxHeight(),
            )
            if (plan.place == BrickPlacement.BESIDE) {
                Column(
                    Modifier.fillMaxHeight().padding(end = PaneLayout.MARGIN, bottom = PaneLayout.MARGIN),
                ) {
                    Box(Modifier.weight(1f).width(plan.brickWidth)) {
                        if (plan.messagesAbove) Messages(state, onEvent, options)
                    }
                    WholeBrick(state.run, onEvent, Modifier.width(plan.brickWidth))
                }
            }
        }
        if (plan.place == BrickPlacement.OVER) {
            val scroll = rememberScrollState()
            val colours = LocalRobotranColours.current
            Box(
                Modifier
                    .align(Alignment.BottomEnd)
                    .fillMaxHeight()
                    .clip(RoundedCornerShape(PaneLayout.MARGIN))
                    .background(colours.desk)
                    .scrollHint(scroll, ground = colours.desk)
                    .verticalScroll(scroll)
                    .padding(PaneLayout.MARGIN),
            ) {
                WholeBrick(state.run, onEvent, Modifier.width(plan.brickWidth))
            }
        }
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
        run.world.robots[run.watched].description,
        { port, pressed ->
            onEvent(RunEvent.SessionTouched(SessionInput.TouchSensor(run.watched, port, pressed)))
        },
    )

/** The brick's display and Run. */
@Composable
internal fun Strip(
    run: RunPaneState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    isLow: Boolean = false,
) = BrickStrip(
    run.brick,
    run.down,
    { onEvent(RunEvent.ButtonPressed(it)) },
    { onEvent(RunEvent.ButtonReleased(it)) },
    modifier,
    isLow,
)
