package robotran.microbit.program

/**
 * Why a board refuses a call, which ends a program that does not catch it.
 *
 * @property python what Python says.
 */
enum class MicrobitError(val python: String) {
    /** Nobody answers at the address: the buggy is off, or it is another. */
    NO_DEVICE("OSError: [Errno 19] ENODEV"),
    INVALID_ARGUMENT("ValueError: invalid arguments"),

    /** The board has no such part. */
    NO_SUCH_PART("AttributeError"),
}
