package robotran.microbitlink.serial

/**
 * What a program on a board has printed.
 *
 * @property lines without the one that it has not ended yet; the oldest go after [MAX_LINES].
 * @property unfinished the beginning of a line.
 * @property error the last error that it has ended with.
 * @property hasEnded whether Python's prompt has come behind what it printed: it does not run any more.
 */
data class BoardConsole(
    val lines: List<String> = emptyList(),
    val unfinished: String = "",
    val error: PythonError? = null,
    val hasEnded: Boolean = false,
) {
    companion object {
        /** How many lines are kept. */
        const val MAX_LINES = 1_000

        /** Longer lines are cut into several. It is in bytes. */
        const val MAX_LINE = 1_000
    }
}

/**
 * The end of a program by an error.
 *
 * @property line the line of `main.py`, null if the error does not lead through it.
 * @property python what Python says, such as `ZeroDivisionError: divide by zero`.
 */
data class PythonError(val line: Int?, val python: String)
