package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.rom.RunState
import robotran.ui.brick.BRICK_ASPECT
import robotran.ui.brick.BrickFront
import robotran.ui.brick.BrickHint
import robotran.ui.brick.BrickStrip
import robotran.ui.brick.LEAST_BRICK_WIDTH
import robotran.ui.drawer.DrawerPage
import robotran.ui.drawer.RunAnnouncer
import robotran.ui.drawer.TaskAndGoals
import robotran.ui.learning.TutorialPane
import robotran.ui.learning.TutorialStrip
import robotran.ui.program.ProgramPane
import robotran.ui.runbar.RunBar
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.LearningEvent
import robotran.ui.workshop.Pane
import robotran.ui.workshop.RunEvent
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorkshopState
import robotran.ui.world.WorldPane
import robotran.world.SessionInput

/** Phone: one pane at a time under three tabs, or the tutorial in its place; the run bar always below. */
@Composable
internal fun NarrowScreen(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit) {
    val tutorial = state.learning.tutorial
    val isReading = tutorial != null && !tutorial.isFolded
    val perform = { event: WorkshopEvent ->
        if (isReading && makesRoom(event)) onEvent(LearningEvent.TutorialFolded(true))
        onEvent(event)
    }
    Column(Modifier.fillMaxSize()) {
        Row(Modifier.background(LocalRobotranColours.current.pane), verticalAlignment = Alignment.CenterVertically) {
            MainMenu(state, onEvent, withWork = true)
            PaneTabs(state.pane, state.mistakes.isNotEmpty(), { perform(WorkshopEvent.PaneChosen(it)) }, Modifier.weight(1f))
        }
        HorizontalDivider(color = LocalRobotranColours.current.line)
        if (isReading) {
            TutorialPane(state.learning, perform, Modifier.weight(1f))
        } else {
            if (tutorial != null) TutorialStrip(state.learning, onEvent)
            PaneAlone(state, onEvent, Modifier.weight(1f))
        }
        state.notice?.let { NoticeBar(it, onEvent) }
        RunBar(state, perform)
        RunAnnouncer(state.run)
    }
}

/** Whether whoever does [event] wants to see a pane instead of the tutorial. */
private fun makesRoom(event: WorkshopEvent): Boolean =
    event is WorkshopEvent.PaneChosen || event == RunEvent.RunPressed || event == LearningEvent.StepTried

@Composable
private fun PaneAlone(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier) = when (state.pane) {
    Pane.PROGRAM -> ProgramPane(state, MOST_MISTAKES, onEvent, modifier)
    Pane.WORLD -> if (state.run.drawer.tab == null) WorldWithStrip(state, onEvent, modifier) else DrawerPage(state.run, onEvent, modifier)
    Pane.BRICK -> BrickAlone(state, onEvent, modifier)
}

/** The brick's strip lies under the paper, or beside it if there is more room there. */
@Composable
private fun WorldWithStrip(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier) {
    BoxWithConstraints(modifier.fillMaxSize().background(LocalRobotranColours.current.desk)) {
        val strip: @Composable () -> Unit = {
            BrickStrip(
                state.run.brick,
                state.down,
                { onEvent(RunEvent.ButtonPressed(it)) },
                { onEvent(RunEvent.ButtonReleased(it)) },
                Modifier.padding(12.dp),
            )
        }
        if (maxWidth > maxHeight) {
            Row(Modifier.fillMaxSize(), verticalAlignment = Alignment.Bottom) {
                Column(Modifier.weight(1f)) {
                    WorldPane(state, onEvent, Modifier.weight(1f))
                    EndExplained(state)
                }
                Column(horizontalAlignment = Alignment.End) {
                    TaskAndGoals(state, onEvent, Modifier.padding(horizontal = 12.dp))
                    strip()
                }
            }
        } else {
            Column(Modifier.fillMaxSize(), horizontalAlignment = Alignment.CenterHorizontally) {
                WorldPane(state, onEvent, Modifier.weight(1f))
                EndExplained(state)
                TaskAndGoals(state, onEvent, Modifier.padding(horizontal = 12.dp))
                strip()
            }
        }
    }
}

/** Why the robot stands still, where the run bar's one word does not say it. */
@Composable
private fun EndExplained(state: WorkshopState) {
    if (state.session.brick.run is RunState.Ended) BrickHint(state.session.brick, Modifier.padding(horizontal = 12.dp))
}

/** The whole brick, as large as it fits; where its buttons would become too small for a finger, it can be scrolled instead. */
@Composable
private fun BrickAlone(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier) {
    BoxWithConstraints(modifier.fillMaxSize().background(LocalRobotranColours.current.desk), Alignment.Center) {
        val width = minOf(maxWidth - MARGIN * 2, (maxHeight - MARGIN * 2) * BRICK_ASPECT).coerceIn(LEAST_BRICK_WIDTH, MOST_BRICK_WIDTH)
        Column(Modifier.verticalScroll(rememberScrollState()).padding(MARGIN), Arrangement.spacedBy(MARGIN)) {
            BrickHint(state.run.brick, Modifier.width(width))
            BrickFront(
                state.run.brick,
                state.down,
                { onEvent(RunEvent.ButtonPressed(it)) },
                { onEvent(RunEvent.ButtonReleased(it)) },
                Modifier.width(width),
                state.world.robots[state.run.watched].ports,
                { port, pressed -> onEvent(RunEvent.SessionTouched(SessionInput.TouchSensor(state.run.watched, port, pressed))) },
            )
        }
    }
}

/** A keyboard on the screen takes half of it: more would push the program out of sight. */
private const val MOST_MISTAKES = 2
private val MARGIN = 16.dp
private val MOST_BRICK_WIDTH = 440.dp
