package robotran.workshop.event

import robotran.language.ProgramLanguage
import robotran.language.ShownLanguage
import robotran.language.source.Diagnostic
import robotran.programs.Program
import robotran.robolang.words.Vocabulary
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument

/** A user action on the programs. */
sealed interface ProgramEvent : WorkshopEvent {
    /** Sets the text of the current file to [text]. */
    data class ProgramEdited(val text: String) : ProgramEvent

    /** Sets the text and the selection of the current file to [draft]. */
    data class DraftChanged(val draft: TextDocument, val kind: EditKind) : ProgramEvent

    /** Undoes the last edit of the current file. */
    data object Undone : ProgramEvent

    /** Redoes the last undone edit. */
    data object Redone : ProgramEvent

    /** Formats the current file. */
    data object Formatted : ProgramEvent

    /** Writes the current program, one in Robolang, in the words of [vocabulary]. */
    data class WordsChosen(val vocabulary: Vocabulary) : ProgramEvent

    /** Opens the search in the current file. The editor confirms with [SearchOpened]. */
    data object SearchRequested : ProgramEvent

    data object SearchOpened : ProgramEvent

    /** Adds or removes a breakpoint before [line], from 1, of the current file. */
    data class BreakpointToggled(val line: Int) : ProgramEvent

    /** Applies the fix of [diagnostic]. */
    data class FixApplied(val diagnostic: Diagnostic) : ProgramEvent

    /** Shows or hides the current program as another text; of several, [kind], or the one shown last for null. */
    data class TranslationShown(val shown: Boolean, val kind: ShownLanguage? = null) : ProgramEvent

    /** Shows the programs of the robot [name]. */
    data class RobotChosen(val name: String) : ProgramEvent

    /** Shows the program in [slot]. */
    data class ProgramChosen(val slot: Int) : ProgramEvent

    /** Shows the file with the index [index] of the current program. */
    data class FileChosen(val index: Int) : ProgramEvent

    /** Appends [program] and shows it. */
    data class ProgramAdded(val program: Program) : ProgramEvent

    /** Creates an empty program in [language]. */
    data class NewProgramRequested(val language: ProgramLanguage) : ProgramEvent

    /** Adds a class to the current Java program, or a file to the current one in NQC, which then includes it. */
    data object FileAdded : ProgramEvent

    /**
     * Renames the file with the index [index] of the current program to [name], which must be valid, see [nameError].
     */
    data class FileRenamed(val index: Int, val name: String) : ProgramEvent

    /**
     * Removes the file with the index [index] of the current Java program, if it is not the only one. It can be
     * restored until the next removal.
     */
    data class FileClosed(val index: Int) : ProgramEvent

    /** Removes the program in [slot]. It can be restored until the next removal. */
    data class ProgramClosed(val slot: Int) : ProgramEvent

    /** Restores the last removed program or class. */
    data object ProgramReopened : ProgramEvent

    /** Dismisses the message about a removed program or class. */
    data object ClosedMessageDismissed : ProgramEvent
}
