package robotran.ui.assignment

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.assignments.doing.NotAllowed
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.withComma
import robotran.projects.AssignmentTries
import robotran.ui.language.LocalLanguage
import robotran.ui.learning.MarkedText
import robotran.ui.resources.Res
import robotran.ui.resources.assignment_best
import robotran.ui.resources.assignment_best_no_goals
import robotran.ui.resources.assignment_no_try
import robotran.ui.resources.assignment_not_allowed_language
import robotran.ui.resources.assignment_not_allowed_word
import robotran.ui.resources.assignment_one_try
import robotran.ui.resources.assignment_tries
import robotran.ui.runbar.oneDecimal
import robotran.ui.theme.LocalRobotranColours
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

/** Seconds with one decimal place, as the pupil's language writes it. */
@Composable
internal fun secondsText(milliseconds: Long): String = oneDecimal(milliseconds / MILLISECONDS_PER_SECOND).let {
    if (LocalLanguage.current == Language.ENGLISH) it else withComma(it)
}

/** The same in all languages. */
internal val ProgramLanguage.ownName: String
    get() = when (this) {
        ProgramLanguage.ROBOLANG -> "Robolang"
        ProgramLanguage.JAVA -> "Java"
    }

private const val MILLISECONDS_PER_SECOND = 1000.0
