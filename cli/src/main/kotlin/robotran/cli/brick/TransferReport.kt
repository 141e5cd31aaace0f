package robotran.cli.brick

import robotran.cli.console.messages
import robotran.console.Console
import robotran.console.ExitCode
import robotran.hublink.DownloadProgress
import robotran.hublink.DownloadResult
import robotran.hublink.sentences.sentence
import robotran.tower.TransferProgress
import robotran.tower.TransferResult

/**
 * Shows a transfer: a progress bar on a terminal, otherwise a line for each tenth.
 *
 * @param isTerminal whether standard error is one.
 * @param slot of LEGO's firmware that is sent to; null for leJOS and for a firmware.
 */
internal class TransferReport(
    private val console: Console,
    private val isTerminal: Boolean,
    private val slot: Int? = null,
) {
    private var width = 0
    private var tenth = 0

    fun show(progress: TransferProgress) = with(progress) {
        show(confirmedBlocks, totalBlocks, console.messages.blocksSent(confirmedBlocks, totalBlocks, secondsLeft))
    }

    /** Shows how much of the datalog has come. */
    fun showEntries(progress: TransferProgress) = with(progress) {
        show(confirmedBlocks, totalBlocks, console.messages.entriesRead(confirmedBlocks, totalBlocks, secondsLeft))
    }

    private fun show(confirmed: Int, total: Int, words: String) {
        val share = confirmed.toDouble() / total.coerceAtLeast(1)
        if (isTerminal) showBar(share, words) else showTenth((share * TENTHS).toInt(), words)
    }

    /** Shows how much of a program a hub has confirmed. */
    fun show(progress: DownloadProgress) = with(progress) {
        show(confirmedBytes, totalBytes, console.messages.bytesSent(confirmedBytes, totalBytes))
    }

    /** Clears the bar. */
    fun clear() {
        if (isTerminal) console.mention("\r" + " ".repeat(width) + "\r")
    }

    /** Tells the result; [success] makes the sentence for a transfer of so many bytes. */
    fun end(result: TransferResult, success: (Int) -> String): ExitCode {
        clear()
        return when (result) {
            is TransferResult.Success -> {
                console.say(success(result.bytes))
                ExitCode.DONE
            }

            is TransferResult.Failure -> {
                console.complain(console.messages.sentence(result.error))
                console.complain(console.messages.sentence(result.remains, slot))
                ExitCode.NO_BRICK
            }
        }
    }

    /** Tells the result of sending a program to a hub. */
    fun end(result: DownloadResult): ExitCode {
        clear()
        return when (result) {
            is DownloadResult.Success -> {
                console.say(console.messages.programInHub(result.bytes))
                ExitCode.DONE
            }

            is DownloadResult.Failure -> {
                console.complain(result.error.sentence(console.language))
                console.complain(result.remains.sentence(console.language))
                ExitCode.NO_BRICK
            }
        }
    }

    private fun showBar(share: Double, words: String) {
        val filled = (share * BAR).toInt()
        val line = "[" + "#".repeat(filled) + " ".repeat(BAR - filled) + "] $words"
        // What a longer line before has left is overwritten.
        width = maxOf(width, line.length)
        console.mention("\r" + line.padEnd(width))
    }

    private fun showTenth(reached: Int, words: String) {
        // A download that begins again goes back.
        if (reached == tenth) return
        tenth = reached
        console.mention("$words\n")
    }

    companion object {
        private const val TENTHS = 10
        private const val BAR = 40

        /** `./robotran` sets this property if standard error is a terminal. */
        private const val TERMINAL = "robotran.terminal"

        fun on(console: Console, slot: Int? = null) =
            TransferReport(console, System.getProperty(TERMINAL) == "true", slot)
    }
}
