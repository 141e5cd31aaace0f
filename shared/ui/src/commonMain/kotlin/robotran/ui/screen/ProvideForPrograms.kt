package robotran.ui.screen

import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.remember
import androidx.compose.ui.unit.Dp
import robotran.ui.assignment.NotAllowedStrip
import robotran.ui.program.LocalAllowedLanguages
import robotran.ui.program.LocalBeginning
import robotran.ui.program.LocalProgramWarning
import robotran.ui.program.blocks.LocalAllowedBlocks
import robotran.ui.runbar.LocalRunIsNext
import robotran.workshop.blocks.allowedBlocks
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningState
import robotran.workshop.state.WorkshopState

/**
 * [content] with what programs and their bar must know of the school: which blocks and languages the open assignment
 * allows and what it does not, the program to begin with in this world, and whether Run is what comes next.
 */
@Composable
internal fun ProvideForPrograms(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    content: @Composable () -> Unit,
) {
    val assignment = state.assignment?.takeIf { it.isOpenForTries }?.assignment
    val allowed = remember(assignment?.words) { assignment?.let { allowedBlocks(it) } }
    val found = state.assignment?.notAllowed.orEmpty()
    val warning = remember(found) {
        found.takeIf { it.isNotEmpty() }?.let { all ->
            @Composable { program: String, maxHeight: Dp ->
                NotAllowedStrip(all, program, maxHeight) { onEvent(AssignmentEvent.NotAllowedShown(it)) }
            }
        }
    }
    val hasBeginning = state.learning.worldTask?.canStart == true
    val beginning = remember(hasBeginning) {
        { onEvent(LearningEvent.WorldProgramRequested) }.takeIf { hasBeginning }
    }
    CompositionLocalProvider(
        LocalBeginning provides beginning,
        LocalRunIsNext provides isRunNext(state.learning),
        LocalAllowedBlocks provides allowed,
        LocalAllowedLanguages provides assignment?.languages?.ifEmpty { null },
        LocalProgramWarning provides warning,
        content = content,
    )
}

/** Whether Run is what comes next: not before a lesson is begun, nor once its task is done and a button leads on. */
private fun isRunNext(learning: LearningState): Boolean {
    val isBegun = learning.tutorial?.run { isFolded || isLoaded } ?: true
    return isBegun && learning.solved == null && learning.elsewhere == null
}
