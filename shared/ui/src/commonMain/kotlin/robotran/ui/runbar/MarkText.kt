package robotran.ui.runbar

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.runcontrol.MarkKind
import robotran.runcontrol.TimelineMark
import robotran.ui.resources.*

/** The text of a mark. */
@Composable
internal fun markText(mark: TimelineMark): String = when (mark.kind) {
    MarkKind.START -> stringResource(Res.string.run_mark_start)
    MarkKind.END -> stringResource(Res.string.run_mark_end)
    MarkKind.FAILURE, MarkKind.REMARK -> mark.text
    MarkKind.GOAL -> stringResource(Res.string.run_mark_goal, mark.text)
    MarkKind.GOAL_LOST -> stringResource(Res.string.run_mark_goal_lost, mark.text)
    MarkKind.BUMP -> stringResource(Res.string.run_mark_bump)
    MarkKind.BEEP -> stringResource(Res.string.run_mark_beep)
    MarkKind.MESSAGE -> stringResource(Res.string.run_mark_message)
}
