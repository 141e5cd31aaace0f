package robotran.workshop.event

import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubTransport

/** A user action while a program is sent to a real hub. */
sealed interface HubSendEvent : SchoolEvent {
    /** Sends the shown program. */
    data object Requested : HubSendEvent

    /** Asks the platform for a hub by [transport]. Browsers allow it only as the direct result of a click. */
    data class TransportRequested(val transport: HubTransport) : HubSendEvent

    data class HubChosen(val device: HubDevice) : HubSendEvent

    /** Looks for hubs again and shows them. */
    data object OtherHubRequested : HubSendEvent

    /** Sends the program to the hub that was found. */
    data object Confirmed : HubSendEvent

    /** Whether the program that is sent next tells which line runs. */
    data class LineSwitched(val isOn: Boolean) : HubSendEvent

    /** Begins again with the same hub. */
    data object Retried : HubSendEvent

    /** Starts the program in the hub. */
    data object Started : HubSendEvent

    data object Stopped : HubSendEvent

    /** Saves the program as Python. */
    data object PythonSaved : HubSendEvent

    /** Shows the mistake in the program, or the line at which it has failed. */
    data object LineShown : HubSendEvent

    /** Cancels the transfer, or closes the sheet if there is none. */
    data object Cancelled : HubSendEvent
}
