package robotran.workshop.event

import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.programs.ProgramTranslation
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.DocumentAnswer

/** A user action on the whole project. */
sealed interface DocumentEvent : WorkshopEvent {
    /** An action on stored projects. */
    sealed interface OfProjectList : DocumentEvent

    /** Creates an empty project; the open one stays in the list. */
    data object NewRequested : DocumentEvent

    /** Asks which robot a new project shall have. */
    data object RobotChoiceRequested : DocumentEvent

    /** Asks which buggy shall carry the [board] of a new project. */
    data class BuggyChoiceRequested(val board: BrickKind) : DocumentEvent

    /** Opens a new project whose robot is the penbot with a [brick], or a [buggy] that carries it. */
    data class NewWithBrick(val brick: BrickKind, val buggy: BuggyKind? = null) : DocumentEvent

    /** Lets the user choose and open files. */
    data object OpenRequested : DocumentEvent

    /** Opens [files], such as those dropped on the window. */
    data class FilesBrought(val files: List<OpenedFile>) : DocumentEvent

    /** Opens the content of [link]. */
    data class LinkOpened(val link: String) : DocumentEvent

    /** Shows or hides the warning that autosave fails; hidden until the reason changes. */
    data class WarningShown(val shown: Boolean) : DocumentEvent

    /** Shows the list of projects. */
    data object ProjectListRequested : OfProjectList

    /** Opens the stored project [id]. */
    data class SavedProjectChosen(val id: String) : OfProjectList

    /** Lets the user type another name for the stored project [id]. */
    data class ProjectRenamingRequested(val id: String) : OfProjectList

    /** Renames the project in question to [name]; null keeps its name. */
    data class ProjectRenamed(val name: String?) : OfProjectList

    /** Stores a copy of the project [id] with a name of its own. */
    data class ProjectDuplicated(val id: String) : OfProjectList

    /** Deletes the stored project [id]; it can be brought back until the list closes or another one is deleted. */
    data class ProjectDeleted(val id: String) : OfProjectList

    /** Brings back the project that was deleted last. */
    data object ProjectDeletionUndone : OfProjectList

    /** Writes the project to its file, or to a chosen one if it has none. */
    data object SaveRequested : DocumentEvent

    data object SaveAsRequested : DocumentEvent

    /** Renames the project to [name]. */
    data class Renamed(val name: String) : DocumentEvent

    data object RenameRequested : DocumentEvent

    /** Creates a link with the whole project. */
    data object LinkRequested : DocumentEvent

    /** Lets the user choose the base URL of links. */
    data object SiteRequested : DocumentEvent

    data object LinkCopied : DocumentEvent

    data object LinkShared : DocumentEvent

    /** Lets the user paste a link to open. */
    data object LinkPastingRequested : DocumentEvent

    /** Exports a project file that reproduces the run. */
    data object ReplayRequested : DocumentEvent

    /** Exports the current program as a file. */
    data object ProgramFileRequested : DocumentEvent

    /** Exports what a program is shown as. */
    data class TranslationSaved(val translation: ProgramTranslation) : DocumentEvent

    /** Exports the current program with everything that a real brick needs. */
    data object KitRequested : DocumentEvent

    /** Says what Robotran is; [version] is empty if it is not known. */
    data class AboutRequested(val version: String) : DocumentEvent

    /** Goes on with My work, which has newer changes than its file, or else opens the file. */
    data class WorkOrFileChosen(val isWork: Boolean) : DocumentEvent

    /** Opens what stopped the app last time, all the same. */
    data object StoppedWorkOpened : DocumentEvent

    /** Writes it to a chosen file without opening it. */
    data object StoppedWorkSaved : DocumentEvent

    /** Answers the question about a file changed by another app or a project that cannot be saved. */
    data class Answered(val answer: DocumentAnswer) : DocumentEvent

    data object DialogClosed : DocumentEvent
}
