package robotran.rcxrom.log

import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCallText

/**
 * One call of a ROM routine in the [RomLog].
 *
 * @property milliseconds when it was made, on the brick's clock.
 * @property meaning the call in words, such as `motor A forward 3`; if it had no effect, why.
 * @property sourceLine the line of the program that made it, from 1; 0 for the firmware itself.
 * @property outcome whether the virtual brick did what a real one would.
 * @property sourceFile the file that the line is in; null if the program has only one.
 */
data class RomLogEntry(
    val milliseconds: Long,
    val call: RomCall,
    val meaning: String,
    val sourceLine: Int,
    val outcome: RomOutcome,
    val sourceFile: String? = null,
) {
    /**
     * The entry as a line of a written log, `1204 0x1a4e 0x2000 1 3 ; motor A forward 3 ; 7`: milliseconds, address and
     * arguments, meaning, source line. Codes and pointers are hexadecimal, numbers decimal and signed; the line of a
     * firmware call is `firmware`, that of a program with several files has the file before it, as in `Robot.java:7`.
     */
    val text: String
        get() = "$milliseconds ${RomCallText.of(call)} ; $meaning ; ${sourcePlace.ifEmpty { "firmware" }}"

    /** The line, with its file if the program has several; empty for the firmware itself. */
    internal val sourcePlace: String
        get() = when {
            sourceLine == 0 -> ""
            sourceFile == null -> sourceLine.toString()
            else -> "$sourceFile:$sourceLine"
        }
}

/** What came of a ROM call. */
enum class RomOutcome {
    /** The virtual brick did it. */
    DONE,

    /** A real brick would do nothing either, or something nobody can foretell: a wrong code, or too few arguments. */
    WRONG_ARGUMENTS,

    /** A routine of a real brick that the virtual brick does not have; nothing happened. */
    NOT_MODELLED,

    /** No routine known begins at this address; a real brick would probably crash. */
    UNKNOWN_ROUTINE,
}
