package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Column
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorkshopState
import robotran.ui.workshop.WorkshopStatus

/**
 * The program to write in, and under it what is wrong with it.
 *
 * @param mostMistakes how many mistakes there is room for.
 */
@Composable
internal fun ProgramPane(state: WorkshopState, mostMistakes: Int, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    val running = state.status as? WorkshopStatus.Running
    Column(modifier.background(LocalRobotranColours.current.pane)) {
        ProgramEditor(
            text = state.programText,
            runningLine = if (state.changed) 0 else running?.line ?: 0,
            mistakes = state.mistakes.map { it.range },
            onEdit = { onEvent(WorkshopEvent.ProgramEdited(it)) },
            modifier = Modifier.weight(1f),
        )
        if (state.mistakes.isNotEmpty()) {
            MistakeList(state.mistakes, mostMistakes, state.mistakePointedOut, { onEvent(WorkshopEvent.FixApplied(it)) })
        }
    }
}
