package robotran.ui.workshop

import robotran.programs.Mistake
import robotran.rom.BrickButton

/** What a person does in the workshop. */
sealed interface WorkshopEvent {
    /** Something a person does with the programs. */
    sealed interface OfPrograms : WorkshopEvent

    /** The text of the file that is shown is now [text]. */
    data class ProgramEdited(val text: String) : OfPrograms

    /** The fix that goes with [mistake] is wanted. */
    data class FixApplied(val mistake: Mistake) : OfPrograms

    /** The program in [slot] is to be shown. */
    data class ProgramChosen(val slot: Int) : OfPrograms

    /** The file [place] of the program that is shown is to be shown. */
    data class FileChosen(val place: Int) : OfPrograms

    /** [program] is to come behind the others and to be shown. */
    data class ProgramAdded(val program: PupilProgram) : OfPrograms

    /** An empty program in [language] is wanted. */
    data class ProgramBegun(val language: ProgramLanguage) : OfPrograms

    /** The Java program that is shown is to have one more class. */
    data object ClassAdded : OfPrograms

    /** The program in [slot] is to go away; it can be brought back as long as no other goes. */
    data class ProgramClosed(val slot: Int) : OfPrograms

    /** The program that went away last is wanted back. */
    data object ProgramReopened : OfPrograms

    /** Run in the run bar: the robot goes back to its start on a clean sheet and the program runs. */
    data object RunPressed : WorkshopEvent

    /** Stop in the run bar: the program ends where it is. */
    data object StopPressed : WorkshopEvent

    /** A finger, a mouse or a key goes down on a button of the brick. */
    data class ButtonPressed(val button: BrickButton) : WorkshopEvent

    /** It comes up again. */
    data class ButtonReleased(val button: BrickButton) : WorkshopEvent

    /** Where there is room for one pane only, it is to be [pane]. */
    data class PaneChosen(val pane: Pane) : WorkshopEvent

    /** The brick's tones are to be heard or not. */
    data class SoundSwitched(val on: Boolean) : WorkshopEvent
}
