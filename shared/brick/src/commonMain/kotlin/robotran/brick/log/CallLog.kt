package robotran.brick.log

/**
 * All calls of a brick, in order. Keeps the newest [CAPACITY] or slightly more, so that a run of hours does not
 * fill the memory; [total] counts all.
 */
class CallLog {
    private var chunks: List<Array<LoggedCall?>> = emptyList()
    private var firstKept = 0L

    /** Number of calls made so far. */
    var total: Long = 0L
        private set

    /** The kept calls, oldest first. The list is immutable and cheap to create, so it can be read every frame. */
    val entries: List<LoggedCall> get() = Entries(chunks, (total - firstKept).toInt())

    /**
     * The call with this [number], counted from 0 over all calls ever made; null if it is no longer kept or not made
     * yet.
     */
    operator fun get(number: Long): LoggedCall? {
        if (number < firstKept || number >= total) return null
        val place = (number - firstKept).toInt()
        return chunks[place / CHUNK][place % CHUNK]
    }

    fun add(entry: LoggedCall) {
        val place = (total - firstKept).toInt()
        if (place % CHUNK == 0) beginChunk()
        chunks.last()[place % CHUNK] = entry
        total++
    }

    /** Changes the entry of the last call. */
    fun amendLast(change: (LoggedCall) -> LoggedCall) {
        val place = (total - firstKept).toInt() - 1
        val chunk = chunks.getOrNull(place / CHUNK) ?: return
        chunk[place % CHUNK]?.let { chunk[place % CHUNK] = change(it) }
    }

    private fun beginChunk() {
        if (chunks.size > CAPACITY / CHUNK) {
            chunks = chunks.drop(1)
            firstKept += CHUNK
        }
        chunks = chunks.plusElement(arrayOfNulls(CHUNK))
    }

    /** A view of the first [size] entries of [chunks]; filled slots are never written again. */
    private class Entries(private val chunks: List<Array<LoggedCall?>>, override val size: Int) :
        AbstractList<LoggedCall>() {
        override fun get(index: Int): LoggedCall {
            if (index !in 0..<size) throw IndexOutOfBoundsException("entry $index of $size")
            return checkNotNull(chunks[index / CHUNK][index % CHUNK])
        }
    }

    companion object {
        /** Min number of calls kept, about 40 MB. */
        const val CAPACITY = 200_000

        private const val CHUNK = 1_000
    }
}
