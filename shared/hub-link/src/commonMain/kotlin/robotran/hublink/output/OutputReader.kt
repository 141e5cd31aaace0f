package robotran.hublink.output

/**
 * Makes a [HubConsole] of the pieces that a hub sends.
 *
 * A line that begins with [MARK] is no text, but tells which line of the Python runs now: the mark and the number of the
 * line in digits.
 *
 * @param map of the program that runs, if it is known.
 */
class OutputReader(private val map: SourceMap?) {
    private val decoder = TextDecoder()
    private val tracebacks = TracebackReader(map)
    private val unfinished = StringBuilder()

    /** What has been printed since the beginning. */
    var console = HubConsole()
        private set

    /** Takes a piece of what is printed, which may end anywhere, within a letter, too. */
    fun add(piece: ByteArray) {
        val text = unfinished.toString() + decoder.add(piece)
        val parts = text.split('\n')
        parts.dropLast(1).forEach { addLine(it.removeSuffix("\r")) }
        unfinished.clear()
        unfinished.append(parts.last())
        while (unfinished.length > HubConsole.MAX_LINE) {
            addLine(unfinished.substring(0, HubConsole.MAX_LINE))
            unfinished.deleteRange(0, HubConsole.MAX_LINE)
        }
        val shown = unfinished.toString().removeSuffix("\r")
        console = console.copy(unfinished = if (shown.startsWith(MARK)) "" else shown)
    }

    private fun addLine(line: String) {
        if (line.startsWith(MARK)) {
            val pythonLine = line.drop(1).toIntOrNull() ?: return
            map?.lineOf(pythonLine)?.let { console = console.copy(runningLine = it) }
            return
        }
        val kept =
            console.lines.takeLast(HubConsole.MAX_LINES - 1) + line.chunked(HubConsole.MAX_LINE).ifEmpty { listOf("") }
        console = console.copy(
            lines = kept.takeLast(HubConsole.MAX_LINES),
            error = tracebacks.add(line) ?: console.error,
            wasStopped = console.wasStopped || line == STOPPED,
        )
    }

    companion object {
        /** What a line begins with that tells where the program is. */
        const val MARK = '\u001E'

        /** What every firmware prints when a program was stopped. */
        private const val STOPPED = "The program was stopped (SystemExit)."
    }
}
