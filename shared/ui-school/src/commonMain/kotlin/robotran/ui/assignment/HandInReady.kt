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
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.documents.LinkAsQrCode
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.HandInStep
import robotran.workshop.state.LinkError

/** @param maxHeight of what is seen at once: the code is seen whole. */
@Composable
internal fun ReadyView(
    step: HandInStep.Ready,
    hasShareSheet: Boolean,
    maxHeight: Dp,
    onEvent: (WorkshopEvent) -> Unit,
) = BoxWithConstraints(Modifier.fillMaxWidth()) {
    val help = SchoolTexts::handInQrHelp
    if (step.link != null && maxWidth >= BESIDE * LocalDensity.current.fontScale) {
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(16.dp)) {
            Column(Modifier.weight(1f), Arrangement.spacedBy(12.dp)) {
                Ways(step, hasShareSheet, onEvent)
                Explanation(help(spoken))
                Quiet(SchoolTexts.handInDecides(spoken), AssignmentTags.HAND_IN_DECIDES)
            }
            Box(Modifier.weight(1f).testTag(AssignmentTags.HAND_IN_QR)) {
                LinkAsQrCode(step.link.orEmpty(), "", maxSide = maxHeight)
            }
        }
    } else {
        Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp)) {
            Ways(step, hasShareSheet, onEvent)
            LinkOrError(step.link, step.linkError, AssignmentTags.HAND_IN_QR, help, maxHeight = maxHeight)
            Quiet(SchoolTexts.handInDecides(spoken), AssignmentTags.HAND_IN_DECIDES)
        }
    }
}

/** What is handed in, and how it gets to the teacher. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Ways(step: HandInStep.Ready, hasShareSheet: Boolean, onEvent: (WorkshopEvent) -> Unit) {
    val result = step.result
    val words = if (result == null) {
        SchoolTexts.handInReadyPlain(spoken, step.name)
    } else {
        val time = secondsText(result.milliseconds)
        SchoolTexts.handInReady(spoken, step.name, result.goalsMet, result.goals, time)
    }
    Explanation(words, Modifier.testTag(AssignmentTags.HAND_IN_READY).announced())
    Explanation(SchoolTexts.handInHow(spoken))
    FlowRow(Modifier, Arrangement.spacedBy(8.dp), Arrangement.spacedBy(8.dp)) {
        Button(SchoolTexts.handInFile(spoken), AssignmentTags.HAND_IN_FILE) {
            onEvent(AssignmentEvent.HandInFileSaved)
        }
        if (step.link != null) {
            val copy = if (step.isCopied) SchoolTexts::handInCopied else SchoolTexts::handInCopy
            Button(copy(spoken), AssignmentTags.HAND_IN_LINK, ButtonKind.SECOND) {
                onEvent(AssignmentEvent.HandInLinkCopied)
            }
            if (hasShareSheet) {
                Button(SchoolTexts.handInShare(spoken), AssignmentTags.HAND_IN_SHARE, ButtonKind.SECOND) {
                    onEvent(AssignmentEvent.HandInLinkShared)
                }
            }
        }
    }
    SaveResult(step.savedAs, step.saveError, AssignmentTags.HAND_IN_SAVED)
}

/** What came of saving a file, if anything. */
@Composable
internal fun SaveResult(savedAs: String?, error: String?, tag: String) {
    val news = Modifier.testTag(tag).announced()
    when {
        error != null -> Explanation(SchoolTexts.handInNotSaved(spoken, error).trim(), news, bad = true)
        savedAs != null -> Explanation(SchoolTexts.handInSaved(spoken, savedAs), news)
    }
}

/**
 * [link] as a QR code, with [qrHelp], or why there is no link; [isForClass] see [LinkAsQrCode].
 *
 * @param maxHeight how high the code may be, so that it can be seen whole.
 */
@Composable
internal fun LinkOrError(
    link: String?,
    problem: LinkError?,
    tag: String,
    qrHelp: Label = DocumentTexts::qrHelp,
    isForClass: Boolean = false,
    maxHeight: Dp = Dp.Infinity,
) {
    val news = Modifier.announced()
    Column(Modifier.fillMaxWidth().testTag(tag), Arrangement.spacedBy(12.dp)) {
        if (link != null) LinkAsQrCode(link, qrHelp(spoken), isForClass, maxHeight)
        when (problem) {
            null -> Unit
            LinkError.NoSite -> Explanation(SchoolTexts.handInNoLink(spoken), news)
            is LinkError.TooLong -> Explanation(problem.message, news)
        }
    }
}

/** From this width on, at default font size, the code is beside the words. */
private val BESIDE = 480.dp
