package robotran.brick.log

/**
 * One call in a [CallLog]: what a program or the firmware told the brick to do.
 *
 * @property milliseconds time of the call on the brick's clock.
 * @property meaning the call in words, such as `motor A forward 3`; if it had no effect, the reason.
 * @property sourceLine the program line of the call, from 1; 0 for the firmware.
 * @property sourceFile the file of the line; null if the program has only one.
 * @property outcome whether the virtual brick did what a real one would.
 * @property callText its name or address and, after blanks, its arguments, such as `0x1a4e 0x2000 1 3`.
 */
interface LoggedCall {
    val milliseconds: Long
    val meaning: String
    val sourceLine: Int
    val sourceFile: String?
    val outcome: CallOutcome
    val group: CallGroup
    val callText: String

    /** Whether the class library made the call by itself, not for a line of the program. */
    val isByLibrary: Boolean get() = false

    /** The line, with its file if the program has several, as in `Robot.java:7`; empty for the firmware. */
    val sourceLocation: String
        get() = when {
            sourceLine == 0 -> ""
            sourceFile == null -> sourceLine.toString()
            else -> "$sourceFile:$sourceLine"
        }

    /**
     * The call as a log line, `1204 0x1a4e 0x2000 1 3 ; motor A forward 3 ; 7`: milliseconds, [callText], meaning,
     * [sourceLocation]. The location of a firmware call is `firmware`.
     */
    val text: String get() = "$milliseconds $callText ; $meaning ; ${sourceLocation.ifEmpty { "firmware" }}"

    /** Passes what identifies the call, such as its time, number and arguments, to [add], always in the same order. */
    fun identify(add: (Long) -> Unit)
}
