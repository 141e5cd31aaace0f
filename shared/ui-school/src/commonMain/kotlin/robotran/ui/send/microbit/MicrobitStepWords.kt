package robotran.ui.send.microbit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.microbitlink.SendProgress
import robotran.microbitlink.serial.BoardConsole
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.HubSendTexts
import robotran.ui.school.texts.MicrobitSendTexts
import robotran.uikit.*
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.state.ChoosingProblem
import robotran.workshop.state.MicrobitSendState
import robotran.workshop.state.MicrobitSendStep
import robotran.workshop.state.ProgramSize

/** What the step of [state] says, and what belongs to it. */
@Composable
internal fun MicrobitStepWords(state: MicrobitSendState, onEvent: (MicrobitSendEvent) -> Unit) {
    val step = state.step
    Explanation(sentenceOf(state), Modifier.testTag(SendTags.SEND_STEP), bad = isBad(state))
    // What can be pressed stays in sight, however long the advice below is.
    if (step is MicrobitSendStep.ManyBoards) BoardChoice(step, onEvent)
    if (step is MicrobitSendStep.Choosing) WayChoice(step, state.microPython != null, onEvent)
    for (advice in adviceOf(state)) Explanation(advice)
    when (step) {
        is MicrobitSendStep.Choosing -> state.size?.let { RoomView(it) }
        is MicrobitSendStep.Sending -> SendingView(step.progress)
        is MicrobitSendStep.Running -> Printed(step)
        is MicrobitSendStep.HexSaved -> CopySteps(step, onEvent)
        else -> Unit
    }
}

private fun isBad(state: MicrobitSendState): Boolean = when (val step = state.step) {
    is MicrobitSendStep.Failed, is MicrobitSendStep.NotCopied -> true
    is MicrobitSendStep.Choosing -> step.problem != null && step.problem != ChoosingProblem.NotKept
    MicrobitSendStep.Found -> state.board?.expected != null
    is MicrobitSendStep.Running -> step.console.error != null
    else -> false
}

@Composable
private fun BoardChoice(step: MicrobitSendStep.ManyBoards, onEvent: (MicrobitSendEvent) -> Unit) =
    step.boards.forEachIndexed { index, board ->
        Button(
            MicrobitSendTexts.boardNumbered(spoken, index + 1),
            SendTags.board(index),
            ButtonKind.DIALOG_ANSWER,
            Modifier.fillMaxWidth(),
        ) { onEvent(MicrobitSendEvent.BoardChosen(board)) }
    }

/** How much of the board the program fills. */
@Composable
private fun RoomView(size: ProgramSize) {
    val colours = LocalRobotranColours.current
    Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp)) {
        Text(
            MicrobitSendTexts.room(spoken, size.bytes, size.maxBytes),
            Modifier.testTag(SendTags.SEND_ROOM),
            TextStyles.body,
            color = colours.quiet,
        )
        Bar { size.share }
    }
}

/** How far a program is; null before the board has begun. */
@Composable
private fun SendingView(progress: SendProgress?) {
    val colours = LocalRobotranColours.current
    Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp)) {
        Bar(Modifier.testTag(SendTags.SEND_PROGRESS)) { partOf(progress) }
        val words = progress?.let { HubSendTexts.bytes(spoken, it.sent, it.total) }
        // An empty line, so that nothing moves when the board begins.
        Text(words.orEmpty(), Modifier.testTag(SendTags.SEND_BLOCK), TextStyles.body, color = colours.quiet)
        if (progress != null && progress.attempt > 1) {
            Explanation(HubSendTexts.repeated(spoken), Modifier.testTag(SendTags.SEND_WEAK))
        }
    }
}

@Composable
private fun Bar(modifier: Modifier = Modifier, part: () -> Float) =
    Progress(part, Modifier.fillMaxWidth().height(8.dp).then(modifier), ground = LocalRobotranColours.current.desk)

/** The part that is through, 0 to 1. */
internal fun partOf(progress: SendProgress?): Float = if (progress == null || progress.total <= 0) {
    0f
} else {
    (progress.sent.toFloat() / progress.total).coerceIn(0f, 1f)
}

/** The last lines that the program has printed; all of them once nothing more comes. */
@Composable
private fun Printed(step: MicrobitSendStep.Running) {
    val console = step.console
    val all = console.lines + listOf(console.unfinished).filter { it.isNotEmpty() }
    if (all.isEmpty()) return
    val colours = LocalRobotranColours.current
    Text(HubSendTexts.printed(spoken), style = TextStyles.body, color = colours.quiet)
    val count = if (step.isGone || console.error != null) BoardConsole.MAX_LINES else RUNNING_LINES
    val before = all.size - count
    if (before > 0) Text(HubSendTexts.lineMore(spoken, before), style = TextStyles.body, color = colours.quiet)
    Text(all.takeLast(count).joinToString("\n"), Modifier.testTag(SendTags.SEND_OUTPUT), TextStyles.code)
}

/** While a program may print, so that the last line is in sight. */
private const val RUNNING_LINES = 6
