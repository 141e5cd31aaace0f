package robotran.rcxrom.log

import robotran.brick.log.CallOutcome
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCallText

/**
 * One call of a ROM routine in the [CallLog].
 *
 * @property milliseconds time of the call on the brick's clock.
 * @property meaning the call in words, such as `motor A forward 3`; if it had no effect, the reason.
 * @property sourceLine the program line of the call, from 1; 0 for the firmware.
 * @property outcome whether the virtual brick did what a real one would.
 * @property sourceFile the file of the line; null if the program has only one.
 */
data class RomLogEntry(
    val milliseconds: Long,
    val call: RomCall,
    val meaning: String,
    val sourceLine: Int,
    val outcome: CallOutcome,
    val sourceFile: String? = null,
) {
    /**
     * The entry as a log line, `1204 0x1a4e 0x2000 1 3 ; motor A forward 3 ; 7`: milliseconds, address and arguments,
     * meaning, source line. Codes and pointers are hexadecimal, numbers signed decimal. The line of a firmware call is
     * `firmware`; in a program with several files the file comes first, as in `Robot.java:7`.
     */
    val text: String
        get() = "$milliseconds ${RomCallText.of(call)} ; $meaning ; ${sourceLocation.ifEmpty { "firmware" }}"

    /** The line, with its file if the program has several; empty for the firmware. */
    internal val sourceLocation: String
        get() = when {
            sourceLine == 0 -> ""
            sourceFile == null -> sourceLine.toString()
            else -> "$sourceFile:$sourceLine"
        }
}

/** The result of a ROM call. */
enum class CallOutcome {
    /** The virtual brick did it. */
    DONE,

    /** A wrong code or too few arguments. A real brick would do nothing either, or something unpredictable. */
    WRONG_ARGUMENTS,

    /** A routine of a real brick that the virtual brick does not implement; nothing happened. */
    NOT_MODELLED,

    /** No known routine starts at this address; a real brick would probably crash. */
    UNKNOWN_ROUTINE,
}
