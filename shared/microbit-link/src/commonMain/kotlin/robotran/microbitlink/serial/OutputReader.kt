package robotran.microbitlink.serial

import robotran.microbitlink.files.MAIN_FILE

/** Makes a [BoardConsole] of the pieces that a board sends. */
internal class OutputReader {
    private var unfinished = ByteArray(0)
    private var inTraceback = false
    private var line: Int? = null

    /** What has been printed since the beginning. */
    var console = BoardConsole()
        private set

    /** Takes a piece, which may end anywhere, within a letter, too. */
    fun add(piece: ByteArray) {
        var start = 0
        val all = unfinished + piece
        for (place in unfinished.size until all.size) {
            val isEnd = all[place] == NEW_LINE
            if (!isEnd && place - start < BoardConsole.MAX_LINE) continue
            addLine(all.decodeToString(start, place).removeSuffix("\r"))
            start = if (isEnd) place + 1 else place
        }
        unfinished = all.copyOfRange(start, all.size)
        val text = unfinished.decodeToString()
        console = if (text == PROMPT) {
            console.copy(unfinished = "", hasEnded = true)
        } else {
            console.copy(unfinished = text.removePrefix(PROMPT).trimEnd('\r', BROKEN_LETTER))
        }
    }

    private fun addLine(whole: String) {
        val text = whole.removePrefix(PROMPT)
        // What Python says of itself when a program has ended.
        if (BANNER.matches(text)) return
        val lines = console.lines.takeLast(BoardConsole.MAX_LINES - 1) + text
        // A line behind the prompt is of a new run, whose program has not failed yet.
        val error = errorWith(text) ?: console.error.takeUnless { console.hasEnded }
        console = console.copy(lines = lines, error = error, hasEnded = false)
    }

    /** The error, if [text] is the last line of a traceback. */
    private fun errorWith(text: String): PythonError? {
        val place = PLACE.find(text)
        return when {
            text == BEGINNING -> {
                inTraceback = true
                line = null
                null
            }

            !inTraceback -> null

            place != null -> {
                if (place.groupValues[1] in MAIN_NAMES) line = place.groupValues[2].toIntOrNull()
                null
            }

            else -> {
                inTraceback = false
                PythonError(line, text.trim()).takeIf { text.isNotBlank() }
            }
        }
    }

    private companion object {
        const val NEW_LINE = '\n'.code.toByte()

        /** What the beginning of a letter becomes, until the rest has come. */
        const val BROKEN_LETTER = '\uFFFD'
        const val PROMPT = ">>> "
        val BANNER = Regex("""MicroPython v.* with nRF.*|Type "help\(\)" for more information\.""")
        const val BEGINNING = "Traceback (most recent call last):"
        val PLACE = Regex("""^ +File "([^"]*)", line (\d+)""")

        /** V1 says that the program was typed in. */
        val MAIN_NAMES = setOf(MAIN_FILE, "__main__")
    }
}
