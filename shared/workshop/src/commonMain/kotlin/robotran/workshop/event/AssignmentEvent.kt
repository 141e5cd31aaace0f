package robotran.workshop.event

import robotran.assignments.doing.NotAllowed
import robotran.assignments.packaging.ScormVersion
import robotran.projects.Assignment

/** A user action on an assignment. */
sealed interface AssignmentEvent : SchoolEvent {
    /** Puts the programs back that the assignment began with. */
    data object BegunAgain : AssignmentEvent

    /** Brings back the programs that [BegunAgain] has replaced. */
    data object BeginningUndone : AssignmentEvent

    /** Shows [found] in its program. */
    data class NotAllowedShown(val found: NotAllowed) : AssignmentEvent

    /** Folds the card of the task to its title and goals, or unfolds it. */
    data class TaskFolded(val folded: Boolean) : AssignmentEvent

    /** An action on the sheet with which a pupil hands in. */
    sealed interface OfHandIn : AssignmentEvent

    /** Opens the sheet. */
    data object HandInRequested : OfHandIn

    /** Closes the sheet, and ends what it is doing. */
    data object HandInClosed : OfHandIn

    /** Returns to the question for the name. */
    data object HandInBackRequested : OfHandIn

    /** The pupil enters [name]. */
    data class NameEntered(val name: String) : OfHandIn

    /** Hands in the program that is in the editor now, or else the best try. */
    data class WorkChosen(val isEditor: Boolean) : OfHandIn

    /** Makes the hand-in, also if the programs have mistakes when [withErrors]. */
    data class HandInMade(val withErrors: Boolean = false) : OfHandIn

    data object HandInFileSaved : OfHandIn

    data object HandInLinkCopied : OfHandIn

    data object HandInLinkShared : OfHandIn

    /** An action of the author's on the page that makes an assignment. */
    sealed interface OfAuthor : AssignmentEvent

    /** Opens the page. Makes an assignment of the open project if it is none. */
    data object MakingRequested : OfAuthor

    data object MakingClosed : OfAuthor

    /** Replaces the assignment by [assignment]. */
    data class Changed(val assignment: Assignment) : OfAuthor

    /** Changes title and task of the world. */
    data class TaskChanged(val title: String, val task: String) : OfAuthor

    data object UndoRequested : OfAuthor

    /** Makes it a project like any other. */
    data object Removed : OfAuthor

    /** Lets the author choose a picture and puts its mark at the end of the text. */
    data object PictureRequested : OfAuthor

    /** Pupils begin with the program at [index] of the first robot, or do not. */
    data class StartSwitched(val index: Int, val on: Boolean) : OfAuthor

    /** The program at [index] of [robotran.workshop.state.AssignmentEditorState.solution] belongs to the solution, or does not. */
    data class SolutionSwitched(val index: Int, val on: Boolean) : OfAuthor

    /** Takes the programs of the solution as they are now; the one that is most likely the solution if there is none. */
    data object SolutionTaken : OfAuthor

    /** Puts the solution into the editor, beside the programs that are there. */
    data object SolutionShown : OfAuthor

    /** Opens the world editor, from which the author comes back to the page. */
    data object WorldRequested : OfAuthor

    /** Adds the world as a variation called [name], and opens it in the world editor. */
    data class VariationAdded(val name: String) : OfAuthor

    /** Opens the variation at [index] in the world editor. */
    data class VariationOpened(val index: Int) : OfAuthor

    /** Runs the solution with all seeds and variations, or ends that. */
    data class CheckRequested(val on: Boolean) : OfAuthor

    /** Saves the file with checks and solution. */
    data object TeacherFileSaved : OfAuthor

    /** Saves the file for pupils. */
    data object PupilFileSaved : OfAuthor

    /** Makes the link for pupils, with its QR code. */
    data object PupilLinkRequested : OfAuthor

    data object PupilLinkCopied : OfAuthor

    data object PupilLinkShared : OfAuthor

    data object PupilLinkClosed : OfAuthor

    /** Saves a package for learning platforms that know [version]. */
    data class PackageSaved(val version: ScormVersion) : OfAuthor

    /** Copies what shows the assignment in a frame of another page. */
    data object EmbedCodeCopied : OfAuthor

    /** Shares what pupils begin with although it solves the task. */
    data object GivingConfirmed : OfAuthor

    data object GivingCancelled : OfAuthor
}
