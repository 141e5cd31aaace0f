package robotran.legofirmware.image

/**
 * The line of a source that made the code from [address] on.
 *
 * @property address of the first byte, in bytes from the beginning of the task or subroutine.
 * @property line from 1.
 * @property file of the line; null if the program has only one.
 */
data class CodeLine(val address: Int, val line: Int, val file: String? = null)

/**
 * Which line of a source made which code. A debugger pauses only where a [CodeLine] begins, so there is one for each
 * statement, also if several are on one line.
 *
 * @param lines for each task and subroutine, in any order; of two with one address, the last counts.
 */
class LineTable(lines: Map<ChunkId, List<CodeLine>>) {
    private val lines: Map<ChunkId, List<CodeLine>> = lines.mapValues { (_, chunkLines) ->
        chunkLines.associateBy { it.address }.values.sortedBy { it.address }
    }

    /** The line that begins at [address]; null if none begins there. */
    fun beginningAt(chunk: ChunkId, address: Int): CodeLine? = lineOf(chunk, address)?.takeIf { it.address == address }

    /** The line that made the code at [address]; null if none did. */
    fun lineOf(chunk: ChunkId, address: Int): CodeLine? {
        val chunkLines = lines[chunk] ?: return null
        val place = chunkLines.binarySearchBy(address) { it.address }
        return chunkLines.getOrNull(if (place >= 0) place else -place - 2)
    }

    /** The lines of a task or subroutine by address. */
    fun linesOf(chunk: ChunkId): List<CodeLine> = lines[chunk].orEmpty()

    companion object {
        /** No line is known. */
        val NONE = LineTable(emptyMap())
    }
}
