package robotran.hublink.output

/**
 * What a program on a hub has printed, and where it is.
 *
 * @property lines what it printed, without the line that it has not ended yet; the oldest go after [MAX_LINES].
 * @property unfinished the beginning of a line.
 * @property runningLine the pupil's line that it has reached last, if it tells.
 * @property error why it has ended, if it was an error.
 * @property wasStopped whether it has ended because it was stopped.
 */
data class HubConsole(
    val lines: List<String> = emptyList(),
    val unfinished: String = "",
    val runningLine: Int? = null,
    val error: ProgramError? = null,
    val wasStopped: Boolean = false,
) {
    companion object {
        /** How many lines are kept. */
        const val MAX_LINES = 1_000

        /** Longer lines are cut into several. */
        const val MAX_LINE = 1_000
    }
}
