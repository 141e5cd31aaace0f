package robotran.cli.grade

import robotran.cli.console.messages
import robotran.console.Console

/**
 * Shows the progress of grading: a progress bar on a terminal, otherwise one line per 10 %.
 *
 * @param total the number of runs. Short jobs show no progress.
 */
internal class GradeProgress(private val console: Console, private val isTerminal: Boolean, private val total: Int) {
    private var done = 0

    fun runIsDone() {
        done++
        if (total < FEWEST) return
        if (isTerminal) console.mention(bar()) else tellTenth()
    }

    private fun tellTenth() {
        if (done * TENTHS / total > (done - 1) * TENTHS / total) {
            console.mention("${done * 100 / total} %: ${console.messages.runsDone(done, total)}\n")
        }
    }

    /** Starts with a carriage return. The last call clears the line. */
    private fun bar(): String {
        val filled = done * WIDTH / total
        val bar = "[" + "#".repeat(filled) + " ".repeat(WIDTH - filled) + "] ${console.messages.runsDone(done, total)}"
        return if (done == total) "\r" + " ".repeat(bar.length) + "\r" else "\r$bar"
    }

    companion object {
        /** The progress of [total] runs, as fits the terminal. */
        fun of(console: Console, total: Int) =
            GradeProgress(console, isTerminal = System.getProperty(TERMINAL) == "true", total = total)

        /** The start script sets this to true if standard error is a terminal. */
        private const val TERMINAL = "robotran.terminal"
        private const val FEWEST = 5
        private const val TENTHS = 10
        private const val WIDTH = 40
    }
}
