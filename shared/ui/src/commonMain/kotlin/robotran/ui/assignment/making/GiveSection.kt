package robotran.ui.assignment.making

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.material3.OutlinedTextField
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.assignments.packaging.ScormVersion
import robotran.ui.assignment.LinkOrProblem
import robotran.ui.assignment.Quiet
import robotran.ui.assignment.SaveResult
import robotran.ui.documents.Explanation
import robotran.ui.documents.LocalLinkNote
import robotran.ui.parts.PrimaryButton
import robotran.ui.parts.SecondButton
import robotran.ui.parts.fieldColours
import robotran.ui.resources.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.MakingState
import robotran.workshop.state.PupilLink

/** Files, link and code. */
@Composable
internal fun GiveSection(state: MakingState, onEvent: (WorkshopEvent) -> Unit) {
    Section(stringResource(Res.string.make_give), "make-give-section") {
        Quiet(stringResource(Res.string.make_give_help), "make-give-help")
        Chips {
            PrimaryButton(stringResource(Res.string.make_teacher_file), "make-teacher-file", {
                onEvent(AssignmentEvent.TeacherFileSaved)
            })
            PrimaryButton(stringResource(Res.string.make_pupil_file), "make-pupil-file", {
                onEvent(AssignmentEvent.PupilFileSaved)
            })
            SecondButton(stringResource(Res.string.make_pupil_link), "make-pupil-link", {
                onEvent(AssignmentEvent.PupilLinkRequested)
            })
        }
        val saved = (state.savedAs ?: state.saveError)?.takeUnless { state.isAboutPackage }
        ComesIntoView(saved) { if (saved != null) SaveResult(state.savedAs, state.saveError, "make-saved") }
        ComesIntoView(state.link?.run { link ?: problem }) { state.link?.let { GiveLink(it, state, onEvent) } }
    }
}

@Composable
private fun GiveLink(link: PupilLink, state: MakingState, onEvent: (WorkshopEvent) -> Unit) = PupilLinkView(
    link,
    "make",
    Res.string.make_qr_help,
    onCopy = { onEvent(AssignmentEvent.PupilLinkCopied) },
    onShare = { onEvent(AssignmentEvent.PupilLinkShared) }.takeIf { state.hasShareSheet },
)

/**
 * [link] to copy, to share, and as a QR code for a class; also why there is none.
 *
 * @param place the beginning of all tags.
 * @param qrHelp what pupils do with the code.
 * @param onShare null if nothing can be shared here.
 */
@Composable
internal fun PupilLinkView(
    link: PupilLink,
    place: String,
    qrHelp: StringResource,
    onCopy: () -> Unit,
    onShare: (() -> Unit)?,
) {
    if (link.link != null) {
        Chips {
            val copy = if (link.isCopied) Res.string.hand_in_copied else Res.string.hand_in_copy
            val news = Modifier.semantics { liveRegion = LiveRegionMode.Polite }
            SecondButton(stringResource(copy), "$place-link-copy", onCopy, news)
            if (onShare != null) SecondButton(stringResource(Res.string.hand_in_share), "$place-link-share", onShare)
        }
    }
    // What is handed in needs no such note: a teacher pastes its link wherever Robotran is open.
    link.link?.let { LocalLinkNote(it) }
    LinkOrProblem(link.link, link.problem, "$place-qr", qrHelp, isForClass = true)
}

/** Packages, and the code for a frame. */
@Composable
internal fun PlatformSection(state: MakingState, onEvent: (WorkshopEvent) -> Unit) {
    Section(stringResource(Res.string.make_platform), "make-platform-section") {
        Quiet(stringResource(Res.string.make_platform_help), "make-platform-help")
        Chips {
            if (state.canPack) {
                for ((version, name) in SCORM) {
                    SecondButton(name, "make-${name.lowercase().replace(' ', '-')}", {
                        onEvent(AssignmentEvent.PackageSaved(version))
                    })
                }
            }
            val copy = if (state.embedCodeCopied) Res.string.make_embed_copied else Res.string.make_embed_copy
            SecondButton(stringResource(copy), "make-embed", { onEvent(AssignmentEvent.EmbedCodeCopied) })
        }
        val packed = (state.savedAs ?: state.saveError)?.takeIf { state.isAboutPackage }
        val result = packed ?: state.embedCode ?: state.embedProblem
        ComesIntoView(if (state.isPacking) "packing" else result) { PlatformResult(state) }
    }
}

@Composable
private fun PlatformResult(state: MakingState) {
    if (state.isPacking) {
        Explanation(
            stringResource(Res.string.make_packing),
            Modifier.testTag("make-packing").semantics { liveRegion = LiveRegionMode.Polite },
        )
    }
    if (state.isAboutPackage) SaveResult(state.savedAs, state.saveError, "make-packed")
    state.embedProblem?.let { LinkOrProblem(null, it, "make-embed-problem") }
    state.embedCode?.let { EmbedCode(it, state.embedCodeCopied) }
}

/** The code stays in sight, since a browser may not let it be copied. */
@Composable
private fun EmbedCode(code: String, isCopied: Boolean) {
    OutlinedTextField(
        code,
        onValueChange = {},
        Modifier.fillMaxWidth().testTag("make-embed-code"),
        readOnly = true,
        label = { Text(stringResource(Res.string.make_embed_code)) },
        maxLines = MAX_CODE_LINES,
        colors = fieldColours(),
    )
    val news = Modifier.testTag("make-embed-copied").semantics { liveRegion = LiveRegionMode.Polite }
    val words = if (isCopied) Res.string.make_embed_copied else Res.string.documents_not_copied
    Explanation(stringResource(words), news)
    LocalLinkNote(code)
}

private const val MAX_CODE_LINES = 3

/** The standards are called alike in all languages. */
private val SCORM = listOf(ScormVersion.SCORM_2004 to "SCORM 2004", ScormVersion.SCORM_1_2 to "SCORM 1.2")
