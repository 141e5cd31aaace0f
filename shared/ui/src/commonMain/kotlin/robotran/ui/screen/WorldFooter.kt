package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.dp
import robotran.ui.assignment.howFar
import robotran.ui.drawer.FootTabs
import robotran.ui.drawer.TaskAndGoals
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.WorkshopState

/**
 * The row below the paper: the tabs of the drawer, task and goals, the small brick, and at its end the button that
 * changes the brick's size. With little room the tabs are in a second row.
 *
 * @param onBrick asks for the whole brick, or for the small one.
 */
@Composable
internal fun WorldFooter(
    state: WorkshopState,
    isWhole: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
    onBrick: (Boolean) -> Unit,
) {
    val colours = LocalRobotranColours.current
    BoxWithConstraints(Modifier.fillMaxWidth().background(colours.pane)) {
        val scale = LocalDensity.current.fontScale.coerceAtLeast(1f)
        val hasChips = state.part { hasTask || session.goals.isNotEmpty() }
        val inOneRow = maxWidth >= BRICK + (TABS + if (hasChips) CHIPS else 0.dp) * scale
        Column {
            HorizontalDivider()
            Row(
                Modifier.fillMaxWidth().padding(vertical = 4.dp).padding(end = 8.dp),
                Arrangement.spacedBy(8.dp, Alignment.End),
                Alignment.CenterVertically,
            ) {
                if (inOneRow) Tabs(state, onEvent, Modifier.weight(1f))
                TaskAndGoals(
                    state.part { hasTask },
                    state.taskShown,
                    state.part { session.goals },
                    onEvent,
                    isSlim = true,
                    howFar = howFar(state.assignment),
                )
                // As large without it, so that nothing moves.
                Box(Modifier.size(STRIP_WIDTH, STRIP_HEIGHT)) {
                    if (!isWhole) SmallBrick(state, onEvent)
                }
                IconButton(
                    if (isWhole) PaneIcons.BRICK_SMALL else PaneIcons.BRICK_WHOLE,
                    if (isWhole) ScreenTexts.brickSmall(spoken) else ScreenTexts.brickWhole(spoken),
                    ScreenTags.BRICK_SIZE,
                ) { onBrick(!isWhole) }
            }
            if (!inOneRow) Tabs(state, onEvent, Modifier)
        }
    }
}

/** In a scope of its own, which each frame of a run composes. */
@Composable
private fun SmallBrick(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit) = Strip(state.run, onEvent, isLow = true)

@Composable
private fun Tabs(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier) =
    FootTabs(state.part { run.drawer.tab }, { onEvent(RunEvent.DrawerChosen(it)) }, modifier)

private val STRIP_WIDTH = 186.dp
private val STRIP_HEIGHT = 56.dp

/** The small brick with the button beside it. */
private val BRICK = 258.dp

/** The widths of task and goals, and of tabs, of which the rest scrolls, at default font size. */
private val CHIPS = 234.dp
private val TABS = 250.dp
