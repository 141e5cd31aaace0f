package robotran.hub.program

/**
 * Why a hub refuses a call, which ends a program that does not catch it.
 *
 * @property python what Python says.
 */
enum class HubError(val python: String) {
    /** Nothing is plugged in there. */
    NO_DEVICE("OSError: [Errno 19] ENODEV"),

    /** Another motor or driving base has the port. */
    BUSY("OSError: [Errno 16] EBUSY"),

    /** What is plugged in is something else. */
    WRONG_DEVICE("OSError: [Errno 95] EOPNOTSUPP"),
    INVALID_ARGUMENT("ValueError: Invalid argument"),

    /** The hub has no such part, such as a loudspeaker. */
    NO_SUCH_PART("AttributeError"),
}
