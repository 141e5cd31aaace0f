package robotran.workshop.event

import robotran.language.ProgramLanguage
import robotran.programs.ProgramDiagnostic
import robotran.textediting.EditKind
import robotran.textediting.text.Draft
import robotran.workshop.state.PupilProgram

/** Something a person does with the programs. */
sealed interface ProgramEvent : WorkshopEvent {
    /** The text of the file that is shown is now [text]. */
    data class ProgramEdited(val text: String) : ProgramEvent

    /** The file that is shown is now [draft], or something else of it is selected. */
    data class Written(val draft: Draft, val kind: EditKind) : ProgramEvent

    /** What was done last to the file that is shown is to be taken back. */
    data object Undone : ProgramEvent

    /** What was taken back last is to be done again. */
    data object Redone : ProgramEvent

    /** The file that is shown is to be laid out as it should be. */
    data object Formatted : ProgramEvent

    /** The search in the file that is shown is to be opened, which [FindingBegun] says is done. */
    data object FindingRequested : ProgramEvent

    data object FindingBegun : ProgramEvent

    /** The program that is shown is to stop before [line], from 1, of the file that is shown, or not any more. */
    data class BreakpointToggled(val line: Int) : ProgramEvent

    /** The fix that goes with [diagnostic] is wanted. */
    data class FixApplied(val diagnostic: ProgramDiagnostic) : ProgramEvent

    /** The translation of a Robolang program is to be shown beside it or not. */
    data class TranslationShown(val shown: Boolean) : ProgramEvent

    /** The programs of the robot called [name] are to be shown. */
    data class RobotChosen(val name: String) : ProgramEvent

    /** The program in [slot] is to be shown. */
    data class ProgramChosen(val slot: Int) : ProgramEvent

    /** The file [place] of the program that is shown is to be shown. */
    data class FileChosen(val place: Int) : ProgramEvent

    /** [program] is to come behind the others and to be shown. */
    data class ProgramAdded(val program: PupilProgram) : ProgramEvent

    /** An empty program in [language] is wanted. */
    data class ProgramBegun(val language: ProgramLanguage) : ProgramEvent

    /** The Java program that is shown is to have one more class. */
    data object ClassAdded : ProgramEvent

    /**
     * The file [place] of the program that is shown is to be called [name], which must be possible, see [nameProblem].
     */
    data class FileRenamed(val place: Int, val name: String) : ProgramEvent

    /**
     * The file [place] of the Java program that is shown is to go away, if there are others; it can be brought back as
     * long as nothing else goes.
     */
    data class FileClosed(val place: Int) : ProgramEvent

    /** The program in [slot] is to go away; it can be brought back as long as nothing else goes. */
    data class ProgramClosed(val slot: Int) : ProgramEvent

    /** What went away last is wanted back. */
    data object ProgramReopened : ProgramEvent

    /** That a program or a class was taken away has been read. */
    data object ClosedRead : ProgramEvent
}
