package robotran.workshop.event

import robotran.workshop.platform.FileKind
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.DocumentAnswer

/** Something a person does with the project as a whole. */
sealed interface DocumentEvent : WorkshopEvent {
    /** Something that is done with the works that are kept. */
    sealed interface OfWorks : DocumentEvent

    /** A new, empty work is wanted; the one that is open stays among all works. */
    data object NewRequested : DocumentEvent

    /** Files are to be chosen and opened. */
    data object OpenRequested : DocumentEvent

    /** [files] are to be opened, such as those dropped on the window. */
    data class FilesBrought(val files: List<OpenedFile>) : DocumentEvent

    /** What is behind [link] is to be opened. */
    data class LinkOpened(val link: String) : DocumentEvent

    /** That the work is not being kept is to be told, or no longer until something else is the reason. */
    data class WarningShown(val shown: Boolean) : DocumentEvent

    /** All works are to be shown. */
    data object ProjectListRequested : OfWorks

    /** The kept work [id] is to be opened. */
    data class SavedProjectChosen(val id: String) : OfWorks

    /** The kept work [id] is to be forgotten; asks first. */
    data class ProjectDeletionRequested(val id: String) : OfWorks

    /** The work that was asked about is to be forgotten for good, or not. */
    data class ProjectDeletionAnswered(val delete: Boolean) : OfWorks

    /** All is to be written to the work's file, or to one that is chosen if it has none. */
    data object SaveRequested : DocumentEvent

    data object SaveAsRequested : DocumentEvent

    /** The project is to be called [name]. */
    data class Renamed(val name: String) : DocumentEvent

    data object RenameRequested : DocumentEvent

    /** A link to all there is is wanted. */
    data object LinkRequested : DocumentEvent

    /** The address that links begin with is to be chosen. */
    data object SiteRequested : DocumentEvent

    data object LinkCopied : DocumentEvent

    data object LinkShared : DocumentEvent

    /** A link is to be pasted and opened. */
    data object LinkPastingRequested : DocumentEvent

    /** The sheet as it is now is to be saved as a picture of [kind], PNG or SVG. */
    data class PictureRequested(val kind: FileKind) : DocumentEvent

    /** A project file that makes the same run again is wanted. */
    data object ReplayRequested : DocumentEvent

    /** The program that is shown is to be saved as a file of its own. */
    data object ProgramFileRequested : DocumentEvent

    /** The program that is shown is to be saved with all that a real brick takes. */
    data object KitRequested : DocumentEvent

    /** The file was changed by somebody else, or the work cannot be kept: [answer] is what to do about it. */
    data class Answered(val answer: DocumentAnswer) : DocumentEvent

    data object DialogClosed : DocumentEvent
}
