package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.ui.brick.BrickFront
import robotran.ui.brick.BrickStrip
import robotran.ui.brick.LEAST_BRICK_WIDTH
import robotran.ui.program.ProgramPane
import robotran.ui.runbar.RunBar
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.Pane
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorkshopState
import robotran.ui.world.WorldPane

/** Phone: one pane at a time under three tabs, the run bar always below. */
@Composable
internal fun NarrowScreen(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit) {
    Column(Modifier.fillMaxSize()) {
        PaneTabs(state.pane, state.mistakes.isNotEmpty(), { onEvent(WorkshopEvent.PaneChosen(it)) })
        val pane = Modifier.weight(1f)
        when (state.pane) {
            Pane.PROGRAM -> ProgramPane(state, MOST_MISTAKES, onEvent, pane)
            Pane.WORLD -> WorldWithStrip(state, onEvent, pane)
            Pane.BRICK -> BrickAlone(state, onEvent, pane)
        }
        RunBar(state, onEvent)
    }
}

@Composable
private fun WorldWithStrip(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier) {
    Column(modifier.background(LocalRobotranColours.current.desk), horizontalAlignment = Alignment.CenterHorizontally) {
        WorldPane(state, Modifier.weight(1f))
        BrickStrip(
            state.session.brick,
            state.down,
            { onEvent(WorkshopEvent.ButtonPressed(it)) },
            { onEvent(WorkshopEvent.ButtonReleased(it)) },
            Modifier.padding(bottom = 12.dp),
        )
    }
}

@Composable
private fun BrickAlone(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier) {
    Box(
        modifier.fillMaxSize().background(LocalRobotranColours.current.desk).verticalScroll(rememberScrollState()).padding(16.dp),
        Alignment.TopCenter,
    ) {
        BrickFront(
            state.session.brick,
            state.down,
            { onEvent(WorkshopEvent.ButtonPressed(it)) },
            { onEvent(WorkshopEvent.ButtonReleased(it)) },
            Modifier.widthIn(LEAST_BRICK_WIDTH, 360.dp),
        )
    }
}

/** A keyboard on the screen takes half of it: more would push the program out of sight. */
private const val MOST_MISTAKES = 2
