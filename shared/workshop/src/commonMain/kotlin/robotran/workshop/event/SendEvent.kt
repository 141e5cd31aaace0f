package robotran.workshop.event

import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind

/** A user action while a program is sent to a real robot. */
sealed interface SendEvent : SchoolEvent {
    /** Sends the shown program. */
    data object Requested : SendEvent

    /** Asks the platform for a tower of [kind]. Browsers allow it only as the direct result of a click. */
    data class TowerRequested(val kind: TowerKind) : SendEvent

    data class TowerChosen(val device: TowerDevice) : SendEvent

    /** Looks for towers again and shows them. */
    data object OtherTowerRequested : SendEvent

    /** Begins again with the same tower. */
    data object Retried : SendEvent

    /** Sends the program into [slot], 1 to 5, of LEGO's own firmware. */
    data class SlotChosen(val slot: Int) : SendEvent

    /** Deletes the programs in all slots of LEGO's own firmware, then sends the program. */
    data object SlotsEmptied : SendEvent

    /** Reads the datalog of LEGO's own firmware. */
    data object DatalogRequested : SendEvent

    /** Saves the datalog that was read as CSV. */
    data object DatalogSaved : SendEvent

    /** Lets the user choose a firmware file. */
    data object FirmwareFileRequested : SendEvent

    /** Sends the chosen firmware, then the program. */
    data object FirmwareConfirmed : SendEvent

    /** Shows the mistake in the program. */
    data object DiagnosticShown : SendEvent

    /** Shows what the robot sends. */
    data object WatchingRequested : SendEvent

    /** Cancels the transfer, or closes the sheet if there is none. */
    data object Cancelled : SendEvent
}
