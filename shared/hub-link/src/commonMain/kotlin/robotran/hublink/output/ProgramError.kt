package robotran.hublink.output

/**
 * Why a program has ended with an error, by the traceback that the hub printed.
 *
 * @property line the pupil's line, null if it is not known.
 * @property port the port that the line is about, if it is about one.
 * @property python the last line of the traceback, such as `ZeroDivisionError: divide by zero`.
 */
data class ProgramError(val kind: ProgramErrorKind, val line: Int?, val port: String?, val python: String)

/** What a program can stumble over on a hub. */
enum class ProgramErrorKind {
    /** A motor or sensor is not on its port, or something else is. */
    MISSING_DEVICE,

    /** A whole number needs more than 31 bits. */
    NUMBER_TOO_LARGE,
    DIVISION_BY_ZERO,
    OUTSIDE_LIST,
    NO_MEMORY,
    OTHER,
    ;

    internal companion object {
        /** The kind of error that the line [python] tells. */
        fun of(python: String): ProgramErrorKind = when (python.substringBefore(':')) {
            "OSError" -> if (DEVICE_ERRORS.any { it in python }) MISSING_DEVICE else OTHER
            "OverflowError" -> NUMBER_TOO_LARGE
            "ZeroDivisionError" -> DIVISION_BY_ZERO
            "IndexError" -> OUTSIDE_LIST
            "MemoryError" -> NO_MEMORY
            else -> OTHER
        }

        /** No device, a device of another kind, a device that was taken away. */
        private val DEVICE_ERRORS = listOf("ENODEV", "Errno 19]", "EOPNOTSUPP", "Errno 95]", "EIO", "Errno 5]")
    }
}
