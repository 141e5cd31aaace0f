package robotran.cli.grade

import robotran.cli.console.Console
import robotran.cli.console.messages

/**
 * Tells how far the grading is: as a bar that grows where there is somebody to see it, otherwise with a line for every
 * tenth.
 *
 * @param total how many runs there are; of few nothing is told.
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

    /** Goes back to the begin of the line first; the last one leaves the line empty. */
    private fun bar(): String {
        val filled = done * WIDTH / total
        val bar = "[" + "#".repeat(filled) + " ".repeat(WIDTH - filled) + "] ${console.messages.runsDone(done, total)}"
        return if (done == total) "\r" + " ".repeat(bar.length) + "\r" else "\r$bar"
    }

    private companion object {
        const val FEWEST = 5
        const val TENTHS = 10
        const val WIDTH = 40
    }
}
