package robotran.rcxrom.log

import robotran.rcxrom.call.RomGroup

/**
 * Selects the entries of a ROM log that meet all conditions.
 *
 * @property groups the subjects of the routines.
 * @property sourceLines the program lines of the calls; 0 stands for the firmware. All if null.
 * @property milliseconds the time range of the calls. Any time if null.
 * @property text a string that the entry's log line must contain, ignoring case.
 * @property onlyReported whether to select only the calls that did not succeed.
 */
data class RomLogFilter(
    val groups: Set<RomGroup> = RomGroup.entries.toSet(),
    val sourceLines: IntRange? = null,
    val milliseconds: LongRange? = null,
    val text: String = "",
    val onlyReported: Boolean = false,
) {
    fun accepts(entry: RomLogEntry): Boolean = (!onlyReported || entry.outcome != RomOutcome.DONE) &&
        (sourceLines == null || entry.sourceLine in sourceLines) &&
        (milliseconds == null || entry.milliseconds in milliseconds) &&
        RomGroup.of(entry.call.address) in groups &&
        (text.isEmpty() || entry.text.contains(text, ignoreCase = true))
}
