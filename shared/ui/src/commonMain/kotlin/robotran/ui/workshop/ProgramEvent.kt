package robotran.ui.workshop

import robotran.programs.Mistake

/** Something a person does with the programs. */
sealed interface ProgramEvent : WorkshopEvent {
    /** The text of the file that is shown is now [text]. */
    data class ProgramEdited(val text: String) : ProgramEvent

    /** The fix that goes with [mistake] is wanted. */
    data class FixApplied(val mistake: Mistake) : ProgramEvent

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

    /** The program in [slot] is to go away; it can be brought back as long as no other goes. */
    data class ProgramClosed(val slot: Int) : ProgramEvent

    /** The program that went away last is wanted back. */
    data object ProgramReopened : ProgramEvent
}
