package robotran.workshop.event

import robotran.microbitlink.dap.PluggedBoard

/** A user action while a program gets onto a micro:bit. */
sealed interface MicrobitSendEvent : SchoolEvent {
    /** Makes the shown program ready for a board. */
    data object Requested : MicrobitSendEvent

    /** Lets the pupil open a file with MicroPython. */
    data object MicroPythonRequested : MicrobitSendEvent

    /** Saves MicroPython with the program in it. */
    data object HexSaved : MicrobitSendEvent

    /** Saves the program alone, as Python. */
    data object PythonSaved : MicrobitSendEvent

    /** Copies MicroPython with the program in it onto the drive of a board. */
    data object DriveRequested : MicrobitSendEvent

    /** Sends by USB, to the board that is known or to one that the platform asks for. Browsers ask only after a click. */
    data object UsbRequested : MicrobitSendEvent

    /** Asks the platform for another board. */
    data object OtherBoardRequested : MicrobitSendEvent

    data class BoardChosen(val board: PluggedBoard) : MicrobitSendEvent

    /** Sends to the board that was found: the program alone if MicroPython is there, or else everything. */
    data object Confirmed : MicrobitSendEvent

    /** Sends MicroPython with the program in it. */
    data object WholeRequested : MicrobitSendEvent

    /** Sends again to the same board. */
    data object Retried : MicrobitSendEvent

    /** Goes back to the ways onto a board. */
    data object BackRequested : MicrobitSendEvent

    /** The pupil types the number that a board shows. */
    data class NumberEntered(val text: String) : MicrobitSendEvent

    /** Shows the mistake in the program, or the line at which it has failed. */
    data object LineShown : MicrobitSendEvent

    /** Cancels what is under way, or closes the sheet if nothing is. */
    data object Cancelled : MicrobitSendEvent
}
