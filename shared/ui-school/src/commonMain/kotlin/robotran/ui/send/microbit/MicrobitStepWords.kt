package robotran.ui.send.microbit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.microbitlink.SendProgress
import robotran.microbitlink.serial.BoardConsole
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.MicrobitSendTexts
import robotran.ui.send.Bar
import robotran.ui.send.Printed
import robotran.ui.send.RUNNING_LINES
import robotran.ui.send.SentPart
import robotran.ui.send.SentPartView
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
    if (step is MicrobitSendStep.Choosing) TransferChoice(step, state.microPython != null, onEvent)
    for (advice in adviceOf(state)) Explanation(advice)
    when (step) {
        is MicrobitSendStep.Choosing -> state.size?.let { RoomView(it) }
        is MicrobitSendStep.Sending -> SentPartView(partOf(step.progress))
        is MicrobitSendStep.Running -> {
            val count = if (step.isGone || step.console.error != null) BoardConsole.MAX_LINES else RUNNING_LINES
            Printed(step.console.lines, step.console.unfinished, count)
        }

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

/** As it is shown; null before the board has begun. */
internal fun partOf(progress: SendProgress?): SentPart? =
    progress?.let { SentPart(it.sent, it.total, isRepeated = it.attempt > 1) }
