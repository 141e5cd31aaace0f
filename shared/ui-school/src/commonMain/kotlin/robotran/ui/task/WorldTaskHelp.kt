package robotran.ui.task

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.ui.learning.TaskHelps
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.WorldTaskState

/** A program to begin with, hints and the solution for the task of a world of the gallery. */
@Composable
internal fun WorldTaskHelp(
    task: WorldTaskState,
    isInBlocks: Boolean,
    isSolved: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
) {
    Column(Modifier.padding(top = 8.dp), Arrangement.spacedBy(8.dp)) {
        if (task.canStart) {
            Button(CommonTexts.worldProgram(spoken), AssignmentTags.WORLD_PROGRAM, ButtonKind.SECOND) {
                onEvent(LearningEvent.WorldProgramRequested)
            }
        }
        TaskHelps(
            task.help,
            isInBlocks,
            isSolved,
            { onEvent(LearningEvent.WorldHintRequested(it)) },
            { onEvent(LearningEvent.WorldSolutionRequested(it)) },
        )
    }
}
