package robotran.brick.log

/**
 * Selects the entries of a log that meet all conditions.
 *
 * @property groups the subjects of the calls.
 * @property sourceLines the program lines of the calls; 0 stands for the firmware. All if null.
 * @property milliseconds the time range of the calls. Any time if null.
 * @property text a string that the entry's log line must contain, ignoring case.
 * @property onlyReported whether to select only the calls that did not succeed.
 */
data class CallLogFilter(
    val groups: Set<CallGroup> = CallGroup.entries.toSet(),
    val sourceLines: IntRange? = null,
    val milliseconds: LongRange? = null,
    val text: String = "",
    val onlyReported: Boolean = false,
) {
    fun accepts(entry: LoggedCall): Boolean = (!onlyReported || entry.outcome != CallOutcome.DONE) &&
        (sourceLines == null || entry.sourceLine in sourceLines) &&
        (milliseconds == null || entry.milliseconds in milliseconds) &&
        entry.group in groups &&
        (text.isEmpty() || entry.text.contains(text, ignoreCase = true))
}
