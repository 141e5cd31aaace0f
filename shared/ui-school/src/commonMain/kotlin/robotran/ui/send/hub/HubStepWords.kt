package robotran.ui.send.hub

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.hublink.DownloadProgress
import robotran.hublink.output.HubConsole
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.HubSendTexts
import robotran.ui.send.Printed
import robotran.ui.send.RUNNING_LINES
import robotran.ui.send.SentPart
import robotran.ui.send.SentPartView
import robotran.uikit.*
import robotran.workshop.event.HubSendEvent
import robotran.workshop.state.HubSendState
import robotran.workshop.state.HubSendStep

/** What the step of [state] says, and what belongs to it. */
@Composable
internal fun HubStepWords(state: HubSendState, onEvent: (HubSendEvent) -> Unit) {
    val step = state.step
    Explanation(sentenceOf(state), Modifier.testTag(SendTags.SEND_STEP), bad = isBad(state))
    // What can be pressed stays in sight, however long the advice below is.
    if (step is HubSendStep.Choosing) HubChoice(step, onEvent)
    if (step is HubSendStep.Found || step is HubSendStep.Ready) LineSwitch(state, onEvent)
    for (advice in adviceOf(state)) Explanation(advice)
    when (step) {
        is HubSendStep.Sending -> SentPartView(partOf(step.progress))
        is HubSendStep.Running -> {
            RunningLine(state, step.console.runningLine)
            Printed(step.console.lines, step.console.unfinished, RUNNING_LINES)
        }

        is HubSendStep.Ended -> Printed(step.console.lines, step.console.unfinished, HubConsole.MAX_LINES)
        else -> Unit
    }
}

private fun isBad(state: HubSendState): Boolean = when (val step = state.step) {
    is HubSendStep.Failed -> true
    HubSendStep.Found -> state.hub?.expected != null
    is HubSendStep.Ended -> step.console.error != null && !step.isGone
    else -> false
}

/** Whether the program that is sent next tells its lines; of one that is in a hub which is gone nothing can be said. */
@Composable
private fun LineSwitch(state: HubSendState, onEvent: (HubSendEvent) -> Unit) {
    if ((state.step as? HubSendStep.Ready)?.isGone == true) return
    SwitchRow(HubSendTexts.showRunningLine(spoken), state.tellsLine, SendTags.SEND_LINE_SWITCH) {
        onEvent(HubSendEvent.LineSwitched(it))
    }
}

/** The text of the pupil's [line], lit as in a run of the simulated robot. */
@Composable
private fun RunningLine(state: HubSendState, line: Int?) {
    val text = line?.let { state.lines.getOrNull(it - 1) } ?: return
    val colours = LocalRobotranColours.current
    Text(
        text.trim(),
        Modifier.fillMaxWidth().background(
            colours.runningLine,
            Shapes.MEDIUM,
        ).padding(8.dp).testTag(SendTags.SEND_LINE),
        TextStyles.code,
    )
}

/** As it is shown; null before the hub has begun. */
internal fun partOf(progress: DownloadProgress?): SentPart? =
    progress?.let { SentPart(it.confirmedBytes, it.totalBytes, isRepeated = it.attempt > 1) }
