package robotran.ui.screen

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*
import robotran.ui.runbar.secondsText
import robotran.workshop.state.SolvedTask

/** What was learned, and time and length of the program beside the pupil's own best, a line each. */
@Composable
internal fun solvedText(solved: SolvedTask): List<String> = listOfNotNull(
    solved.learned?.let { stringResource(Res.string.outcome_learned, it) },
    timeText(solved),
    linesText(solved),
)

@Composable
private fun timeText(solved: SolvedTask): String {
    val time = secondsText(solved.milliseconds)
    val best = solved.bestMilliseconds
    return when {
        best == null -> stringResource(Res.string.outcome_time, time)
        solved.milliseconds < best -> stringResource(Res.string.outcome_time_best, time, secondsText(best))
        else -> stringResource(Res.string.outcome_time_before, time, secondsText(best))
    }
}

@Composable
private fun linesText(solved: SolvedTask): String {
    val best = solved.bestLines
    return when {
        best == null -> stringResource(Res.string.outcome_lines, solved.lines)
        solved.lines < best -> stringResource(Res.string.outcome_lines_best, solved.lines, best)
        else -> stringResource(Res.string.outcome_lines_before, solved.lines, best)
    }
}
