package robotran.ui.assignment.making

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.assignments.packaging.ScormVersion
import robotran.ui.assignment.LinkOrError
import robotran.ui.assignment.Quiet
import robotran.ui.assignment.SaveResult
import robotran.ui.documents.LocalLinkNote
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AssignmentEditorState
import robotran.workshop.state.PupilLink

/** Files, link and code. */
@Composable
internal fun GiveSection(state: AssignmentEditorState, onEvent: (WorkshopEvent) -> Unit) {
    Section(SchoolTexts.makeGive(spoken), AssignmentTags.MAKE_GIVE_SECTION) {
        Quiet(SchoolTexts.makeGiveHelp(spoken), AssignmentTags.MAKE_GIVE_HELP)
        Chips {
            Button(SchoolTexts.makeTeacherFile(spoken), AssignmentTags.MAKE_TEACHER_FILE) {
                onEvent(AssignmentEvent.TeacherFileSaved)
            }
            Button(SchoolTexts.makePupilFile(spoken), AssignmentTags.MAKE_PUPIL_FILE) {
                onEvent(AssignmentEvent.PupilFileSaved)
            }
            Button(SchoolTexts.makePupilLink(spoken), AssignmentTags.MAKE_PUPIL_LINK, ButtonKind.SECOND) {
                onEvent(AssignmentEvent.PupilLinkRequested)
            }
        }
        val saved = (state.savedAs ?: state.saveError)?.takeUnless { state.isAboutPackage }
        ComesIntoView(saved) {
            if (saved !=
                null
            ) {
                SaveResult(state.savedAs, state.saveError, AssignmentTags.MAKE_SAVED)
            }
        }
        ComesIntoView(state.link?.run { link ?: problem }) { state.link?.let { GiveLink(it, state, onEvent) } }
    }
}

@Composable
private fun GiveLink(link: PupilLink, state: AssignmentEditorState, onEvent: (WorkshopEvent) -> Unit) = PupilLinkView(
    link,
    AssignmentTags.MAKE,
    SchoolTexts::makeQrHelp,
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
internal fun PupilLinkView(link: PupilLink, place: String, qrHelp: Label, onCopy: () -> Unit, onShare: (() -> Unit)?) {
    if (link.link != null) {
        Chips {
            val copy = if (link.isCopied) SchoolTexts::handInCopied else SchoolTexts::handInCopy
            val news = Modifier.announced()
            Button(copy(spoken), AssignmentTags.linkCopy(place), ButtonKind.SECOND, news, onClick = onCopy)
            if (onShare != null) {
                Button(
                    SchoolTexts.handInShare(spoken),
                    AssignmentTags.linkShare(place),
                    ButtonKind.SECOND,
                    onClick = onShare,
                )
            }
        }
    }
    // What is handed in needs no such note: a teacher pastes its link wherever Robotran is open.
    link.link?.let { LocalLinkNote(it) }
    LinkOrError(link.link, link.problem, AssignmentTags.qr(place), qrHelp, isForClass = true)
}

/** Packages, and the code for a frame. */
@Composable
internal fun PlatformSection(state: AssignmentEditorState, onEvent: (WorkshopEvent) -> Unit) {
    Section(SchoolTexts.makePlatform(spoken), AssignmentTags.MAKE_PLATFORM_SECTION) {
        Quiet(SchoolTexts.makePlatformHelp(spoken), AssignmentTags.MAKE_PLATFORM_HELP)
        Chips {
            if (state.canPack) {
                for ((version, name) in SCORM) {
                    Button(name, AssignmentTags.makePackage(name), ButtonKind.SECOND) {
                        onEvent(AssignmentEvent.PackageSaved(version))
                    }
                }
            }
            val copy = if (state.embedCodeCopied) SchoolTexts::makeEmbedCopied else SchoolTexts::makeEmbedCopy
            Button(copy(spoken), AssignmentTags.MAKE_EMBED, ButtonKind.SECOND) {
                onEvent(AssignmentEvent.EmbedCodeCopied)
            }
        }
        val packed = (state.savedAs ?: state.saveError)?.takeIf { state.isAboutPackage }
        val result = packed ?: state.embedCode ?: state.embedError
        ComesIntoView(if (state.isPacking) "packing" else result) { PlatformResult(state) }
    }
}

@Composable
private fun PlatformResult(state: AssignmentEditorState) {
    if (state.isPacking) {
        Explanation(
            SchoolTexts.makePacking(spoken),
            Modifier.testTag(AssignmentTags.MAKE_PACKING).announced(),
        )
    }
    if (state.isAboutPackage) SaveResult(state.savedAs, state.saveError, AssignmentTags.MAKE_PACKED)
    state.embedError?.let { LinkOrError(null, it, AssignmentTags.MAKE_EMBED_PROBLEM) }
    state.embedCode?.let { EmbedCode(it, state.embedCodeCopied) }
}

/** The code stays in sight, since a browser may not let it be copied. */
@Composable
private fun EmbedCode(code: String, isCopied: Boolean) {
    TextField(
        code,
        { },
        Modifier.fillMaxWidth().testTag(AssignmentTags.MAKE_EMBED_CODE),
        SchoolTexts.makeEmbedCode(spoken),
        1..MAX_CODE_LINES,
        extras = FieldExtras(isReadOnly = true),
    )
    val news = Modifier.testTag(AssignmentTags.MAKE_EMBED_COPIED).announced()
    val words = if (isCopied) SchoolTexts::makeEmbedCopied else DocumentTexts::notCopied
    Explanation(words(spoken), news)
    LocalLinkNote(code)
}

private const val MAX_CODE_LINES = 3

/** The standards are called alike in all languages. */
private val SCORM = listOf(ScormVersion.SCORM_2004 to "SCORM 2004", ScormVersion.SCORM_1_2 to "SCORM 1.2")
