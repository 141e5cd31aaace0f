package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.documents.OpenFilesError
import robotran.documents.ProjectSummary
import robotran.world.World

/**
 * The project as a document.
 *
 * @property name what the pupil calls it; empty as long as it has none.
 * @property fileName the file it was opened from or saved to; null if there is none.
 * @property saved whether the file has all that is there; true as well while nothing was done yet.
 * @property error why the work is not being kept, null if it is.
 * @property warningShown whether that is told; false once somebody has put it away.
 * @property dialog what is asked or shown, null if nothing.
 * @property hasShareSheet whether links can be handed to other apps.
 */
@Immutable
data class DocumentState(
    val name: String = "",
    val fileName: String? = null,
    val saved: Boolean = true,
    val error: AutosaveError? = null,
    val warningShown: Boolean = true,
    val dialog: DocumentDialog? = null,
    val hasShareSheet: Boolean = false,
)

/** Why work is not being kept. */
sealed interface AutosaveError {
    data object Full : AutosaveError

    /** There is more in the work than could be read again. */
    data object TooLong : AutosaveError

    /** @property reason what the platform says. */
    data class Failed(val reason: String) : AutosaveError
}

/** What the app asks or shows about the document. */
sealed interface DocumentDialog {
    /** @property name what the work is called now. */
    data class Renaming(val name: String) : DocumentDialog

    /**
     * All kept works.
     *
     * @property works the newest first; null until they are there.
     * @property deleting the one that somebody wants to forget.
     */
    data class ProjectList(val works: List<ProjectListEntry>?, val deleting: ProjectListEntry? = null) : DocumentDialog

    /**
     * @property link to all there is; null until it is made.
     * @property tooLong why there is none, one sentence; null if there can be one.
     * @property copied whether it is in the clipboard.
     */
    data class SharingLink(val link: String? = null, val tooLong: String? = null, val copied: Boolean = false) :
        DocumentDialog

    /** There is no link, since nobody knows where it would lead to; there is the file. */
    data object SharingFile : DocumentDialog

    /** @property error why the link that was pasted cannot be used. */
    data class PastingLink(val error: String? = null) : DocumentDialog

    /** The work's file has been changed by somebody else since it was opened. */
    data class ChangedElsewhere(val fileName: String) : DocumentDialog

    /** The work cannot be kept, so it would be lost if another took its place. */
    data object WouldBeLost : DocumentDialog

    /** Files cannot be opened. */
    data class Rejected(val error: OpenFilesError) : DocumentDialog
}

/**
 * A work in the list of all.
 *
 * @property time when it was last kept, as people write it.
 * @property isOpen whether it is the one on the screen.
 * @property world where it is to run; null until that was looked up, or if it cannot be.
 * @property programs the names of its programs, robot by robot.
 */
@Immutable
data class ProjectListEntry(
    val entry: ProjectSummary,
    val time: String,
    val isOpen: Boolean,
    val world: World? = null,
    val programs: List<String> = emptyList(),
)
