package robotran.ui.send.hub

import androidx.compose.runtime.Composable
import robotran.hublink.HubError
import robotran.hublink.Remains
import robotran.hublink.UnseenCause
import robotran.hublink.connection.HubTransport
import robotran.hublink.messages.HubTexts
import robotran.hublink.sentences.sentence
import robotran.ui.school.texts.HubSendTexts
import robotran.ui.school.texts.SendTexts
import robotran.ui.send.errorText
import robotran.uikit.*
import robotran.workshop.state.FoundHub
import robotran.workshop.state.HubSendState
import robotran.workshop.state.HubSendStep

/** What happens in the step of [state], or what is wrong and what to do, in one sentence or two. */
@Composable
internal fun sentenceOf(state: HubSendState): String = when (val step = state.step) {
    HubSendStep.Building -> HubSendTexts.building(spoken)
    is HubSendStep.HasErrors -> HubSendTexts.mistake(spoken)
    HubSendStep.NoCompiler -> HubSendTexts.noCompiler(spoken)
    HubSendStep.CompilerFailed -> SendTexts.compilerFailed(spoken)
    is HubSendStep.NoWay -> step.savedAs?.let { HubSendTexts.savedPython(spoken, it) } ?: HubSendTexts.noWay(spoken)
    HubSendStep.Looking -> HubSendTexts.looking(spoken)

    is HubSendStep.Choosing ->
        if (step.isMissing) HubSendTexts.chooseMissing(spoken) else HubSendTexts.choose(spoken)

    HubSendStep.Connecting -> HubSendTexts.connecting(spoken)
    HubSendStep.Found -> state.hub?.let { sentenceOf(it) }.orEmpty()
    is HubSendStep.Sending -> HubSendTexts.sending(spoken, state.hub?.name.orEmpty())
    HubSendStep.Cancelled -> HubSendTexts.cancelled(spoken)
    is HubSendStep.Ready -> if (step.isGone) HubSendTexts.readyAlone(spoken) else HubSendTexts.ready(spoken)
    is HubSendStep.Running -> sentenceOf(step)
    is HubSendStep.Ended -> sentenceOf(step)
    is HubSendStep.Failed -> sentenceOf(step.error)
}

/** What else helps in the step of [state], a paragraph each. */
@Composable
internal fun adviceOf(state: HubSendState): List<String> = when (val step = state.step) {
    is HubSendStep.HasErrors -> listOf(errorText(step.first))
    is HubSendStep.NoWay -> if (step.isRefused) listOf(HubSendTexts.notSaved(spoken)) else emptyList()
    is HubSendStep.Choosing -> causesOf(step).map { it.sentence(spoken) }
    HubSendStep.Found -> state.hub?.let { adviceOf(it) }.orEmpty()
    is HubSendStep.Sending -> listOf(HubSendTexts.keepNear(spoken))
    is HubSendStep.Ended -> listOfNotNull(step.console.error?.line?.let { HubSendTexts.atLine(spoken, it) })
    is HubSendStep.Failed -> causesOf(step.error).map { it.sentence(spoken) } + remainsOf(step.remains)
    else -> emptyList()
}

@Composable
private fun sentenceOf(hub: FoundHub): String = hub.expected?.let { HubSendTexts.otherKind(spoken, hub.model, it) }
    ?: HubSendTexts.found(spoken, hub.name, hub.model)

@Composable
private fun adviceOf(hub: FoundHub): List<String> = listOfNotNull(
    HubSendTexts.about(spoken, hub.firmware, hub.room),
    HubSendTexts.batteryLow(spoken).takeIf { hub.isBatteryLow },
    HubTexts.newerThanKnown(spoken, hub.firmware).takeIf { hub.isNewerThanKnown },
)

@Composable
private fun sentenceOf(step: HubSendStep.Running): String {
    val line = step.console.runningLine
    return when {
        step.isStopping -> HubSendTexts.stopping(spoken)
        line != null -> HubSendTexts.runningLine(spoken, line)
        else -> HubSendTexts.running(spoken)
    }
}

@Composable
private fun sentenceOf(step: HubSendStep.Ended): String = when {
    step.isGone -> HubSendTexts.lost(spoken)
    step.console.wasStopped -> HubSendTexts.stopped(spoken)
    else -> step.console.error?.sentence(spoken) ?: HubSendTexts.ended(spoken)
}

/** The causes of a hub that is not seen follow as advice. */
@Composable
private fun sentenceOf(error: HubError): String =
    if (error is HubError.NotSeen) HubTexts.notSeen(spoken) else error.sentence(spoken)

@Composable
private fun remainsOf(remains: Remains): List<String> =
    if (remains == Remains.AS_BEFORE) emptyList() else listOf(remains.sentence(spoken))

private fun causesOf(error: HubError): List<UnseenCause> = (error as? HubError.NotSeen)?.causes.orEmpty()

/** Why a hub may not be in a list in which nothing was found; at a cable it neither hides nor is too far. */
private fun causesOf(step: HubSendStep.Choosing): List<UnseenCause> = when {
    !step.isMissing -> emptyList()
    HubTransport.BLUETOOTH in step.transports -> UnseenCause.entries
    else -> listOf(UnseenCause.OFF, UnseenCause.LEGO_FIRMWARE)
}
