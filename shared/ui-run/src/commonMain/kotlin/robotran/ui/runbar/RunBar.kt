package robotran.ui.runbar

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.dp
import robotran.simulation.Breakpoint
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.WorkshopStatus

/**
 * Run, Pause, Step, Stop, the status, the speed, and the timeline; always visible at the bottom of the window. It is a
 * single row if that fits. Controls without room are in a panel behind one button. [more] is placed at its end.
 *
 * @param caretLine the line that "run to the caret" runs to.
 * @param isLow whether the window has little height.
 */
@Composable
fun RunBar(
    run: RunPaneState,
    status: WorkshopStatus,
    caretLine: Breakpoint,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    isLow: Boolean = false,
    more: (@Composable () -> Unit)? = null,
) {
    var panelOpen by remember { mutableStateOf(false) }
    BoxWithConstraints(modifier.fillMaxWidth().background(LocalRobotranColours.current.pane)) {
        val room = RunBarSpace.of(maxWidth, LocalDensity.current.fontScale, runButtonWidth(), more != null, isLow)
        val inOneRow = room.status == StatusPlace.OVER_TIMELINE
        val edge = if (room.status == StatusPlace.ABOVE) 12.dp else 16.dp
        Column(Modifier.padding(horizontal = edge, vertical = if (inOneRow) 4.dp else 8.dp)) {
            if (room.status == StatusPlace.ABOVE) {
                RunStatus(run, status, StatusSpace.BROAD, Modifier.fillMaxWidth().padding(bottom = 8.dp))
            }
            Row(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalAlignment = Alignment.CenterVertically) {
                Controls(run, status, caretLine, room, onEvent)
                when (room.status) {
                    StatusPlace.OVER_TIMELINE -> {
                        Column(Modifier.weight(1f)) {
                            RunStatus(run, status, StatusSpace.LINE, Modifier.fillMaxWidth().padding(horizontal = 8.dp))
                            Timeline(run, { onEvent(RunEvent.Scrubbed(it)) }, Modifier.fillMaxWidth())
                        }
                    }

                    StatusPlace.BESIDE -> {
                        RunStatus(run, status, StatusSpace.BROAD, Modifier.weight(1f).padding(start = 4.dp))
                    }

                    StatusPlace.ABOVE -> {}
                }
                if (room.speed) SpeedChooser(run.speed, { onEvent(RunEvent.SpeedChosen(it)) })
                IconButton(
                    RunIcons.SETTINGS,
                    RunTexts.more(spoken),
                    RunTags.RUN_MORE,
                    IconButtonKind.RUN,
                ) { panelOpen = true }
                more?.invoke()
            }
            if (!inOneRow) Timeline(run, { onEvent(RunEvent.Scrubbed(it)) }, Modifier.fillMaxWidth())
        }
    }
    if (panelOpen) RunPanel(run, caretLine, onEvent, { panelOpen = false })
}

@Composable
private fun Controls(
    run: RunPaneState,
    status: WorkshopStatus,
    caretLine: Breakpoint,
    room: RunBarSpace,
    onEvent: (WorkshopEvent) -> Unit,
) {
    RunButton(
        pulsing = run.untouched && status == WorkshopStatus.Ready,
        onClick = { onEvent(RunEvent.RunPressed) },
        room = room.runWord,
    )
    PauseButton(run.isPaused, run.pausable, { onEvent(RunEvent.PausePressed) }, room = room.words)
    StepButton(caretLine, onEvent, room.words, menu = room.stepMenu)
    StopButton(run.stoppable, { onEvent(RunEvent.StopPressed) }, room = room.words)
}
