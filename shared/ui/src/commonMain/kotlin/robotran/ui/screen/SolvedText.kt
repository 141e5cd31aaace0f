package robotran.ui.screen

import androidx.compose.runtime.Composable
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.workshop.state.SolvedTask

/** Time and length of the program beside the pupil's own best. */
@Composable
internal fun recordText(solved: SolvedTask): String = "${timeText(solved)}\n${linesText(solved)}"

@Composable
private fun timeText(solved: SolvedTask): String {
    val time = secondsText(solved.milliseconds)
    val best = solved.bestMilliseconds
    return when {
        best == null -> RunTexts.outcomeTime(spoken, time)
        solved.milliseconds < best -> RunTexts.outcomeTimeBest(spoken, time, secondsText(best))
        else -> RunTexts.outcomeTimeBefore(spoken, time, secondsText(best))
    }
}

@Composable
private fun linesText(solved: SolvedTask): String {
    val best = solved.bestLines
    return when {
        best == null -> RunTexts.outcomeLines(spoken, solved.lines)
        solved.lines < best -> RunTexts.outcomeLinesBest(spoken, solved.lines, best)
        else -> RunTexts.outcomeLinesBefore(spoken, solved.lines, best)
    }
}
