package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.brick.kind.BrickKind
import robotran.documents.OpenFilesError
import robotran.documents.ProjectSummary
import robotran.projects.Project
import robotran.world.World

/**
 * The open project as a document.
 *
 * @property name the project's name; empty if it has none.
 * @property fileName the file it was opened from or saved to; null if there is none.
 * @property saved whether the file is up to date; also true for an unchanged new project.
 * @property error why autosave fails; null if it works.
 * @property warningShown whether [error] is shown; false once the user has closed it.
 * @property dialog the open dialog; null if there is none.
 * @property hasShareSheet whether links can be shared with other apps.
 * @property hasGoals whether its world has goals, so that hand-ins for it can be graded.
 * @property canSend whether the shown robot has a brick to which programs can be sent; others have a kit.
 * @property hasFirmwareImage whether the shown program is for LEGO's own firmware: that has no kit, but an image.
 * @property recentFiles the files of other projects, the last used first; only where a platform shows them.
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
    val hasGoals: Boolean = false,
    val canSend: Boolean = true,
    val hasFirmwareImage: Boolean = false,
    val recentFiles: List<RecentFile> = emptyList(),
)

/** The file [name] of the stored project [id]. */
@Immutable
data class RecentFile(val id: String, val name: String)

/** Why autosave fails. */
sealed interface AutosaveError {
    data object Full : AutosaveError

    /** The device's store does not answer. */
    data object NoAnswer : AutosaveError

    /** The project exceeds the max size that can be read again. */
    data object TooLong : AutosaveError

    /** @property reason the platform's error message. */
    data class Failed(val reason: String) : AutosaveError
}

/** A dialog about the document. */
sealed interface DocumentDialog {
    /**
     * Which robot a new project shall have.
     *
     * @property board what shall be plugged into a buggy, which is asked for; null while the brick is asked for.
     */
    data class RobotChoice(val board: BrickKind? = null) : DocumentDialog

    /** @property name the current name of the project. */
    data class Renaming(val name: String) : DocumentDialog

    /**
     * The list of stored projects.
     *
     * @property projects newest first; null while loading.
     * @property renaming the ID of the project that gets another name; null for none.
     * @property deleted the ID of the project among them that was deleted and can be brought back; null for none.
     * @property notice what did not work, since the list covers all other notices; null for nothing.
     */
    data class ProjectList(
        val projects: List<ProjectListEntry>?,
        val renaming: String? = null,
        val deleted: String? = null,
        val notice: Notice? = null,
    ) : DocumentDialog

    /**
     * @property link a link with the whole project; null until it is created.
     * @property tooLong an error message if the project is too long for a link; null if it fits.
     * @property copied whether it was copied to the clipboard.
     */
    data class SharingLink(val link: String? = null, val tooLong: String? = null, val copied: Boolean = false) :
        DocumentDialog

    /** Links are not possible without a base URL, but the file can be shared. */
    data object SharingFile : DocumentDialog

    /** @property error why the pasted link is invalid. */
    data class PastingLink(val error: String? = null) : DocumentDialog

    /** Another app has changed the project's file since it was opened. */
    data class ChangedElsewhere(val fileName: String) : DocumentDialog

    /** The project cannot be saved, so it would be lost if another one replaced it. */
    data object WouldBeLost : DocumentDialog

    /**
     * My work has changes that are not in the file [fileName], which was to be opened.
     *
     * @property workTime when they were stored, formatted.
     * @property fileTime when the file was changed, formatted; null if the platform does not tell.
     */
    data class NewerInMyWork(val fileName: String, val workTime: String, val fileTime: String?) : DocumentDialog

    /**
     * What was to be opened stopped the app the last time.
     *
     * @property name the name of the project; empty if it has none or comes from a link.
     */
    data class StoppedLastTime(val name: String, val work: StoppedWork) : DocumentDialog

    /** @property version the version of the app; empty if it is not known. */
    data class About(val version: String) : DocumentDialog

    /** Files cannot be opened. */
    data class Rejected(val error: OpenFilesError) : DocumentDialog
}

/** What stopped the app when it was opened last. */
sealed interface StoppedWork {
    /** The stored project [id]. */
    data class Stored(val id: String) : StoppedWork

    data class OfLink(val link: String) : StoppedWork

    data object OfFiles : StoppedWork
}

/**
 * An entry in the list of projects.
 *
 * @property time when it was last stored, formatted.
 * @property isOpen whether it is the open project.
 * @property project its content; null until it is loaded, or if it cannot be.
 */
@Immutable
data class ProjectListEntry(
    val entry: ProjectSummary,
    val time: String,
    val isOpen: Boolean,
    val project: Project? = null,
) {
    val world: World? get() = project?.world

    /** The names of its programs, by robot. */
    val programs: List<String> get() = project?.robots.orEmpty().flatMap { robot -> robot.programs.map { it.name } }
}
