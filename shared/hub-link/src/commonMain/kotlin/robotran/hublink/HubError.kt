package robotran.hublink

/** What can go wrong between app and hub. `HubMessages` has a sentence for each. */
sealed interface HubError {
    /** No hub is seen. [causes] are what may be the matter, the likeliest first. */
    data class NotSeen(val causes: List<UnseenCause>) : HubError

    /** The connection was lost, or could not be made: too far, switched off, unplugged. */
    data object OutOfReach : HubError

    /** Another app, window or person is connected. */
    data object Taken : HubError

    /** The system or the user does not let the app use the hub. */
    data object NotAllowed : HubError

    /** The system or the user does not let the app use Bluetooth at all. */
    data object BluetoothNotAllowed : HubError

    /** A hub answers, but not with Pybricks: LEGO's own firmware is on it. */
    data object LegoFirmware : HubError

    /** The firmware is older than 3.2. [firmware] is null if it does not tell. */
    data class TooOld(val firmware: HubVersion?) : HubError

    /** The program is larger than the hub's room. */
    data class TooLarge(val bytes: Int, val maxBytes: Int) : HubError

    /** The program has the whole number [number], which needs more than the 31 bits of a hub. */
    data class NumberTooLarge(val number: String) : HubError

    /** What should be sent is no compiled program, or one for another kind of hub. */
    data object NotAProgram : HubError

    /** A program runs, or another app sends one. */
    data object Busy : HubError

    /** The program does not end when it is told to. */
    data object DoesNotStop : HubError

    /** The hub has no program to start. */
    data object NoProgram : HubError

    /** The connection was lost while a program was sent. */
    data object BrokenOff : HubError

    /** The hub is connected, but answers too seldom. */
    data object BadConnection : HubError

    /** The hub has refused for a reason that we do not know; [code] is null where the system keeps it back. */
    data class Refused(val code: Int?) : HubError
}

/** Why a hub may not be seen. */
enum class UnseenCause {
    OFF,

    /** It does not show itself while a program runs. */
    PROGRAM_RUNS,
    TOO_FAR,

    /** Connected to another app or machine. */
    TAKEN,

    /** Its own firmware shows itself to LEGO's app only. */
    LEGO_FIRMWARE,

    /** Bluetooth is switched off, on the hub or on this machine. */
    BLUETOOTH_OFF,
}
