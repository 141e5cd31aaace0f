package robotran.ui.workshop

import robotran.robolang.Diagnostic
import robotran.rom.BrickButton

/** What a person does in the workshop. */
sealed interface WorkshopEvent {
    /** The program text is now [text]. */
    data class ProgramEdited(val text: String) : WorkshopEvent

    /** The fix that goes with [mistake] is wanted. */
    data class FixApplied(val mistake: Diagnostic) : WorkshopEvent

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
