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
import org.jetbrains.compose.resources.stringResource
import robotran.simulation.Breakpoint
import robotran.ui.resources.Res
import robotran.ui.resources.run_more
import robotran.ui.theme.LocalRobotranColours
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.WorkshopStatus

/**
 * Run, Pause, Step, Stop, the status, the speed, and the timeline; always visible. Controls without room are in a panel
 * behind one button. [more] is placed at its end.
 *
 * @param caretLine the line that "run to the caret" runs to.
 */
@Composable
internal fun RunBar(
    run: RunPaneState,
    status: WorkshopStatus,
    caretLine: Breakpoint,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    more: @Composable () -> Unit = {},
) {
    var panelOpen by remember { mutableStateOf(false) }
    BoxWithConstraints(modifier.fillMaxWidth().background(LocalRobotranColours.current.pane)) {
        val room = RunBarSpace.of(maxWidth, LocalDensity.current.fontScale.coerceAtLeast(1f))
        Column(Modifier.padding(horizontal = 16.dp, vertical = 8.dp)) {
            if (!room.statusBeside) {
                RunStatus(
                    run,
                    status,
                    StatusSpace.BROAD,
                    Modifier.fillMaxWidth().padding(bottom = 8.dp),
                )
            }
            Row(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalAlignment = Alignment.CenterVertically) {
                Controls(run, status, caretLine, room, onEvent)
                if (room.statusBeside) RunStatus(run, status, room.status, Modifier.weight(1f).padding(start = 4.dp))
                if (room.speed) SpeedChooser(run.speed, { onEvent(RunEvent.SpeedChosen(it)) })
                QuietButton(RunIcon.SETTINGS, stringResource(Res.string.run_more), "run-more", { panelOpen = true })
                more()
            }
            Timeline(run, { onEvent(RunEvent.Scrubbed(it)) }, Modifier.fillMaxWidth())
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
