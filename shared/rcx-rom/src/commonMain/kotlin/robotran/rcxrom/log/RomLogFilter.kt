package robotran.rcxrom.log

import robotran.rcxrom.call.RomGroup

/**
 * Chooses entries of a ROM log; those that meet all conditions.
 *
 * @property groups what the routines are about.
 * @property sourceLines the lines of the program that made the calls; 0 stands for the firmware. All if null.
 * @property milliseconds when the calls were made. Always if null.
 * @property text what the entry's line in a written log must contain, in upper or lower case.
 * @property onlyReported whether only calls are wanted that did not do what their program may have hoped for.
 */
data class RomLogFilter(
    val groups: Set<RomGroup> = RomGroup.entries.toSet(),
    val sourceLines: IntRange? = null,
    val milliseconds: LongRange? = null,
    val text: String = "",
    val onlyReported: Boolean = false,
) {
    /** Whether [entry] is one of those wanted. */
    fun accepts(entry: RomLogEntry): Boolean = (!onlyReported || entry.outcome != RomOutcome.DONE) &&
        (sourceLines == null || entry.sourceLine in sourceLines) &&
        (milliseconds == null || entry.milliseconds in milliseconds) &&
        RomGroup.of(entry.call.address) in groups &&
        (text.isEmpty() || entry.text.contains(text, ignoreCase = true))
}
