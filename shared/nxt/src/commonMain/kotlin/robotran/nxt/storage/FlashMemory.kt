package robotran.nxt.storage

/**
 * The part of an NXT's flash memory that programs use: [PAGES] pages of [PAGE_BYTES] bytes. It is not part of the memory
 * for objects, and keeps what is written while the brick is switched off. Before that, all its bits are 1.
 *
 * @param files what is in it at the beginning, as far as there is room.
 */
class FlashMemory(files: List<NxtFile> = emptyList()) {
    private val pages = arrayOfNulls<ByteArray>(PAGES)
    private var known: List<NxtFile>? = null

    init {
        if (files.isNotEmpty()) FileTable.write(this, files)
    }

    /** The files, in the order in which they were made; the same list while nothing changes. */
    val files: List<NxtFile> get() = known ?: FileTable.read(this).also { known = it }

    /** The bytes behind the last file. */
    val freeBytes: Int
        get() {
            val taken = files.sumOf { FileTable.pagesOf(it.size) }
            return (PAGES - FileTable.FIRST_FILE_PAGE - taken) * PAGE_BYTES
        }

    /** Copies page [number] into [target]; false if there is no such page or no room. */
    fun readPage(number: Int, target: ByteArray): Boolean {
        if (number !in 0 until PAGES || target.size < PAGE_BYTES) return false
        page(number).copyInto(target, endIndex = PAGE_BYTES)
        return true
    }

    /** Writes the first bytes of [source] to page [number]; false if there is no such page or too few bytes. */
    fun writePage(number: Int, source: ByteArray): Boolean {
        if (number !in 0 until PAGES || source.size < PAGE_BYTES) return false
        pages[number] = source.copyOf(PAGE_BYTES)
        known = null
        return true
    }

    /** Removes the file [name]; the others move together. */
    fun delete(name: String) = FileTable.write(this, files.filter { it.name != name })

    /** Removes all files. */
    fun format() = FileTable.write(this, emptyList())

    /** The content of page [number]; must not be changed. */
    internal fun page(number: Int): ByteArray = pages[number] ?: CLEAR

    /** So many bytes from the beginning of page [first] on. */
    internal fun bytes(first: Int, count: Int): ByteArray {
        val all = ByteArray(count)
        for (start in 0 until count step PAGE_BYTES) {
            page(first + start / PAGE_BYTES).copyInto(all, start, 0, minOf(PAGE_BYTES, count - start))
        }
        return all
    }

    /** Writes a file from the beginning of page [first] on. */
    internal fun write(first: Int, file: NxtFile) {
        for (start in 0 until file.size step PAGE_BYTES) {
            val page = ByteArray(PAGE_BYTES)
            file.copyInto(page, 0, start, minOf(file.size, start + PAGE_BYTES))
            writePage(first + start / PAGE_BYTES, page)
        }
    }

    companion object {
        const val PAGE_BYTES = 256

        /** Whether a brick can keep [files]: their names, number and sizes have limits. */
        fun holds(files: List<NxtFile>): Boolean = FlashMemory(files).files == files

        /** Half of the 256 kilobytes; firmware and menu have the rest (estimate). */
        const val PAGES = 512

        internal const val BYTES = PAGES.toLong() * PAGE_BYTES

        private val CLEAR = ByteArray(PAGE_BYTES) { -1 }
    }
}
