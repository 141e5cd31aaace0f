package robotran.nxt.storage

/**
 * The table of files as leJOS NXJ keeps it in the flash memory: a sign, the number of files, and for each file the page
 * where it begins, its length, its attributes and its name. Files are in the order in which they were made.
 */
internal object FileTable {
    const val PAGE = 1

    /** The first page that files can have. */
    const val FIRST_FILE_PAGE = 3

    /** Most files that a brick can have. */
    const val MOST_FILES = 30

    private const val SIGN = "V_0.4"
    private const val ENTRY_BYTES = 8
    private const val BYTE = 0xFF
    private const val BYTE_BITS = 8

    /** The number of bytes of the table with [files]; it must fit into a page. */
    fun sizeOf(files: List<NxtFile>): Int = SIGN.length + 1 + files.sumOf { ENTRY_BYTES + it.name.length }

    /** The pages that a file of so many bytes takes; an empty one keeps one free. */
    fun pagesOf(bytes: Int): Int = maxOf(1, (bytes + FlashMemory.PAGE_BYTES - 1) / FlashMemory.PAGE_BYTES)

    /**
     * The files that the table in [flash] tells; none if it is damaged. A program may have written any table: what [write]
     * could not write, and all behind it, is left out.
     */
    fun read(flash: FlashMemory): List<NxtFile> {
        val table = flash.page(PAGE)
        if (SIGN.indices.any { table[it].toInt() != SIGN[it].code }) return emptyList()
        var place = SIGN.length
        val count = table[place++].toInt()
        var room = FlashMemory.PAGES - FIRST_FILE_PAGE
        return buildList {
            repeat(minOf(count, MOST_FILES)) {
                if (place + ENTRY_BYTES > table.size) return@buildList
                val page = number(table, place, 2)
                val length = number(table, place + 2, Int.SIZE_BYTES)
                val nameLength = table[place + ENTRY_BYTES - 1].toInt() and BYTE
                val attributes = table[place + ENTRY_BYTES - 2].toInt() and BYTE
                place += ENTRY_BYTES
                val end = page * FlashMemory.PAGE_BYTES.toLong() + length
                val isReal = length >= 0 && end <= FlashMemory.BYTES && nameLength <= NxtFile.LONGEST_NAME
                if (!isReal || place + nameLength > table.size || pagesOf(length) > room) return@buildList
                room -= pagesOf(length)
                val name = (place until place + nameLength).map { (table[it].toInt() and BYTE).toChar() }
                add(NxtFile(name.joinToString(""), flash.bytes(page, length), attributes))
                place += nameLength
            }
        }
    }

    /** Writes [files] into [flash], one behind the other, with their table; as many as there is room for. */
    fun write(flash: FlashMemory, files: List<NxtFile>) {
        val table = ByteArray(FlashMemory.PAGE_BYTES)
        SIGN.forEachIndexed { index, sign -> table[index] = sign.code.toByte() }
        var place = SIGN.length + 1
        var page = FIRST_FILE_PAGE
        var count = 0
        for (file in files) {
            val behind = page + pagesOf(file.size)
            val isFull = count == MOST_FILES || place + ENTRY_BYTES + file.name.length > table.size
            if (isFull || behind > FlashMemory.PAGES) break
            put(table, place, page, 2)
            put(table, place + 2, file.size, Int.SIZE_BYTES)
            table[place + ENTRY_BYTES - 2] = file.attributes.toByte()
            table[place + ENTRY_BYTES - 1] = file.name.length.toByte()
            place += ENTRY_BYTES
            for (character in file.name) table[place++] = character.code.toByte()
            flash.write(page, file)
            page = behind
            count++
        }
        table[SIGN.length] = count.toByte()
        flash.writePage(PAGE, table)
    }

    /** The lowest byte comes first. */
    private fun number(bytes: ByteArray, place: Int, count: Int): Int =
        (count - 1 downTo 0).fold(0) { value, index -> value shl BYTE_BITS or (bytes[place + index].toInt() and BYTE) }

    private fun put(bytes: ByteArray, place: Int, value: Int, count: Int) {
        for (index in 0 until count) bytes[place + index] = (value shr index * BYTE_BITS).toByte()
    }
}
