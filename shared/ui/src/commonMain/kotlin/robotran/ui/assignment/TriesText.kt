package robotran.ui.assignment

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.projects.AssignmentTries
import robotran.ui.resources.*
import robotran.ui.runbar.secondsText
import robotran.workshop.state.AssignmentState

/** How far the pupil is: the number of tries and the best of them. */
@Composable
internal fun triesText(tries: AssignmentTries): String {
    val best = tries.best?.result ?: return stringResource(Res.string.assignment_no_try)
    val count = if (tries.tries == 1) {
        stringResource(Res.string.assignment_one_try)
    } else {
        stringResource(Res.string.assignment_tries, tries.tries)
    }
    val time = secondsText(best.milliseconds)
    val how = if (best.goals == 0) {
        stringResource(Res.string.assignment_best_no_goals, time)
    } else {
        stringResource(Res.string.assignment_best, best.goalsMet, best.goals, time)
    }
    return "$count $how"
}

/** The same for screen readers, beside the button that shows the task; empty if nobody counts. */
@Composable
internal fun howFar(assignment: AssignmentState?): String =
    assignment?.takeIf { it.isOpenForTries }?.let { triesText(it.tries) }.orEmpty()

/** What the screen calls the world or variation [name], which is empty for the world of the assignment itself. */
@Composable
internal fun worldName(name: String): String = name.ifEmpty { stringResource(Res.string.hand_in_own_world) }
