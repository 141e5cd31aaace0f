package robotran.ui.assignment

import androidx.compose.runtime.Composable
import robotran.projects.AssignmentTries
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.state.AssignmentState

/** How far the pupil is: the number of tries and the best of them. */
@Composable
fun triesText(tries: AssignmentTries): String {
    val best = tries.best?.result ?: return SchoolTexts.assignmentNoTry(spoken)
    val count = if (tries.tries == 1) {
        SchoolTexts.assignmentOneTry(spoken)
    } else {
        SchoolTexts.assignmentTries(spoken, tries.tries)
    }
    val time = secondsText(best.milliseconds)
    val how = if (best.goals == 0) {
        SchoolTexts.assignmentBestNoGoals(spoken, time)
    } else {
        SchoolTexts.assignmentBest(spoken, best.goalsMet, best.goals, time)
    }
    return "$count $how"
}

/** The same for screen readers, beside the button that shows the task; empty if nobody counts. */
@Composable
fun howFar(assignment: AssignmentState?): String =
    assignment?.takeIf { it.isOpenForTries }?.let { triesText(it.tries) }.orEmpty()

/** What the screen calls the world or variation [name], which is empty for the world of the assignment itself. */
@Composable
fun worldName(name: String): String = name.ifEmpty { SchoolTexts.handInOwnWorld(spoken) }
