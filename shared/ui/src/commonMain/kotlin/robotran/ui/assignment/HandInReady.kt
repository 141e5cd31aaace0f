package robotran.ui.assignment

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.documents.Explanation
import robotran.ui.documents.LinkAsQrCode
import robotran.ui.parts.PrimaryButton
import robotran.ui.parts.SecondButton
import robotran.ui.resources.*
import robotran.ui.runbar.secondsText
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.HandInStep
import robotran.workshop.state.LinkProblem

/** @param maxHeight of what is seen at once: the code is seen whole. */
@Composable
internal fun ReadyView(
    step: HandInStep.Ready,
    hasShareSheet: Boolean,
    maxHeight: Dp,
    onEvent: (WorkshopEvent) -> Unit,
) = BoxWithConstraints(Modifier.fillMaxWidth()) {
    val help = Res.string.hand_in_qr_help
    if (step.link != null && maxWidth >= BESIDE * LocalDensity.current.fontScale) {
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(16.dp)) {
            Column(Modifier.weight(1f), Arrangement.spacedBy(12.dp)) {
                Ways(step, hasShareSheet, onEvent)
                Explanation(stringResource(help))
                Quiet(stringResource(Res.string.hand_in_decides), "hand-in-decides")
            }
            Box(Modifier.weight(1f).testTag("hand-in-qr")) {
                LinkAsQrCode(step.link.orEmpty(), "", maxSide = maxHeight)
            }
        }
    } else {
        Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp)) {
            Ways(step, hasShareSheet, onEvent)
            LinkOrProblem(step.link, step.linkProblem, "hand-in-qr", help, maxHeight = maxHeight)
            Quiet(stringResource(Res.string.hand_in_decides), "hand-in-decides")
        }
    }
}

/** What is handed in, and how it gets to the teacher. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Ways(step: HandInStep.Ready, hasShareSheet: Boolean, onEvent: (WorkshopEvent) -> Unit) {
    val result = step.result
    val words = if (result == null) {
        stringResource(Res.string.hand_in_ready_plain, step.name)
    } else {
        val time = secondsText(result.milliseconds)
        stringResource(Res.string.hand_in_ready, step.name, result.goalsMet, result.goals, time)
    }
    Explanation(words, Modifier.testTag("hand-in-ready").semantics { liveRegion = LiveRegionMode.Polite })
    Explanation(stringResource(Res.string.hand_in_how))
    FlowRow(Modifier, Arrangement.spacedBy(8.dp), Arrangement.spacedBy(8.dp)) {
        PrimaryButton(stringResource(Res.string.hand_in_file), "hand-in-file", {
            onEvent(AssignmentEvent.HandInFileSaved)
        })
        if (step.link != null) {
            val copy = if (step.isCopied) Res.string.hand_in_copied else Res.string.hand_in_copy
            SecondButton(stringResource(copy), "hand-in-link", { onEvent(AssignmentEvent.HandInLinkCopied) })
            if (hasShareSheet) {
                SecondButton(stringResource(Res.string.hand_in_share), "hand-in-share", {
                    onEvent(AssignmentEvent.HandInLinkShared)
                })
            }
        }
    }
    SaveResult(step.savedAs, step.saveError, "hand-in-saved")
}

/** What came of saving a file, if anything. */
@Composable
internal fun SaveResult(savedAs: String?, error: String?, tag: String) {
    val news = Modifier.testTag(tag).semantics { liveRegion = LiveRegionMode.Polite }
    when {
        error != null -> Explanation(stringResource(Res.string.hand_in_not_saved, error).trim(), news, bad = true)
        savedAs != null -> Explanation(stringResource(Res.string.hand_in_saved, savedAs), news)
    }
}

/**
 * [link] as a QR code, with [qrHelp], or why there is no link; [isForClass] see [LinkAsQrCode].
 *
 * @param maxHeight how high the code may be, so that it can be seen whole.
 */
@Composable
internal fun LinkOrProblem(
    link: String?,
    problem: LinkProblem?,
    tag: String,
    qrHelp: StringResource = Res.string.documents_qr_help,
    isForClass: Boolean = false,
    maxHeight: Dp = Dp.Infinity,
) {
    val news = Modifier.semantics { liveRegion = LiveRegionMode.Polite }
    Column(Modifier.fillMaxWidth().testTag(tag), Arrangement.spacedBy(12.dp)) {
        if (link != null) LinkAsQrCode(link, stringResource(qrHelp), isForClass, maxHeight)
        when (problem) {
            null -> Unit
            LinkProblem.NoSite -> Explanation(stringResource(Res.string.hand_in_no_link), news)
            is LinkProblem.TooLong -> Explanation(problem.message, news)
        }
    }
}

/** From this width on, at default font size, the code is beside the words. */
private val BESIDE = 480.dp
