package robotran.ui.runbar

import androidx.compose.runtime.Composable
import robotran.runcontrol.MarkKind
import robotran.runcontrol.TimelineMark
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/** The text of a mark. */
@Composable
internal fun markText(mark: TimelineMark): String = when (mark.kind) {
    MarkKind.START -> RunTexts.markStart(spoken)
    MarkKind.END -> RunTexts.markEnd(spoken)
    MarkKind.FAILURE, MarkKind.WARNING -> mark.text
    MarkKind.GOAL -> CommonTexts.markGoal(spoken, mark.text)
    MarkKind.GOAL_LOST -> CommonTexts.markGoalLost(spoken, mark.text)
    MarkKind.BUMP -> RunTexts.markBump(spoken)
    MarkKind.BEEP -> RunTexts.markBeep(spoken)
    MarkKind.MESSAGE -> RunTexts.markMessage(spoken)
}
