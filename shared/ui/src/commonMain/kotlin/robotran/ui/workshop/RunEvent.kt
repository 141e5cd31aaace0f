package robotran.ui.workshop

import robotran.rom.BrickButton
import robotran.world.SessionInput

/** Something a person does with the run. */
sealed interface RunEvent : WorkshopEvent {
    /** Run in the run bar: the robot goes back to its start on a clean sheet and the program runs. */
    data object RunPressed : RunEvent

    /** Stop in the run bar: the program ends where it is. */
    data object StopPressed : RunEvent

    /** A finger, a mouse or a key goes down on a button of the brick. */
    data class ButtonPressed(val button: BrickButton) : RunEvent

    /** It comes up again. */
    data class ButtonReleased(val button: BrickButton) : RunEvent

    /** Something is done to the session by hand, such as dragging the robot; it is recorded with its time. */
    data class SessionTouched(val input: SessionInput) : RunEvent
}
