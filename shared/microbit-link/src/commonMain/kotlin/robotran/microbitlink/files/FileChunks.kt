package robotran.microbitlink.files

import robotran.microbitlink.u8

/**
 * The file system of MicroPython on a board: chunks of 128 bytes, counted from 1. The last page of the area holds no
 * files, only a mark, until the board has swept its files; then it is the first one.
 */
internal object FileChunks {
    const val SIZE = 128

    /** What a chunk holds of a file. */
    const val DATA = 126

    /** The first byte of the page without files. */
    const val PAGE_MARK = 0xFD

    const val FIRST_OF_FILE = 0xFE
    const val NONE = 0xFF

    /** The longest name, in bytes. */
    const val LONGEST_NAME = 120

    /** The bytes before a name: where the file ends in its last chunk, and how long the name is. */
    const val HEAD = 2

    /** Numbers of chunks are single bytes, and the highest ones are marks. */
    const val MOST = 240

    /** How many chunks a file takes. One that fills its last chunk takes one more. */
    fun count(nameBytes: Int, bytes: Int): Int = (HEAD + nameBytes + bytes + DATA) / DATA

    /** The largest file with a name of [nameBytes] that fits into [chunks]. */
    fun largest(nameBytes: Int, chunks: Int): Int = maxOf(0, chunks * DATA - 1 - HEAD - nameBytes)
}

/** The chunks of [files] in a fresh area, one after the other. The caller has looked whether they fit. */
internal fun encodeFiles(files: Map<String, ByteArray>): ByteArray {
    val chunks = mutableListOf<ByteArray>()
    for ((name, content) in files) {
        val nameBytes = name.encodeToByteArray()
        val end = (FileChunks.HEAD + nameBytes.size + content.size) % FileChunks.DATA
        val file = byteArrayOf(end.toByte(), nameBytes.size.toByte()) + nameBytes + content
        val count = FileChunks.count(nameBytes.size, content.size)
        for (part in 0 until count) {
            val number = chunks.size + 1
            val from = part * FileChunks.DATA
            val chunk = ByteArray(FileChunks.SIZE) { FileChunks.NONE.toByte() }
            chunk[0] = (if (part == 0) FileChunks.FIRST_OF_FILE else number - 1).toByte()
            file.copyInto(chunk, 1, minOf(from, file.size), minOf(from + FileChunks.DATA, file.size))
            if (part < count - 1) chunk[FileChunks.SIZE - 1] = (number + 1).toByte()
            chunks += chunk
        }
    }
    return ByteArray(chunks.size * FileChunks.SIZE) { chunks[it / FileChunks.SIZE][it % FileChunks.SIZE] }
}

/** The files in [area], a file system with pages of [pageSize] bytes; null if they do not fit together. */
internal fun decodeFiles(area: ByteArray, pageSize: Int): Map<String, ByteArray>? {
    if (area.size < pageSize) return emptyMap()
    val isSwept = area.u8(0) == FileChunks.PAGE_MARK
    val start = if (isSwept) pageSize else 0
    val reader = ChunkReader(area.copyOfRange(start, start + area.size - pageSize))
    val files = mutableMapOf<String, ByteArray>()
    for (number in reader.firstChunks()) {
        val (name, content) = reader.file(number) ?: return null
        if (files.put(name, content) != null) return null
    }
    return files
}

private class ChunkReader(private val bytes: ByteArray) {
    private val chunks = bytes.size / FileChunks.SIZE

    fun firstChunks(): List<Int> = (1..chunks).filter { mark(it) == FileChunks.FIRST_OF_FILE }

    /** The file that begins in chunk [first]; null if it is broken. */
    fun file(first: Int): Pair<String, ByteArray>? {
        val end = data(first, 0)
        val nameBytes = data(first, 1)
        val name = name(first, nameBytes) ?: return null
        val numbers = chain(first) ?: return null
        val from = FileChunks.HEAD + nameBytes
        val size = (numbers.size - 1) * FileChunks.DATA + end - from
        if (end > FileChunks.DATA || size < 0) return null
        val content = ByteArray(size) { place ->
            val at = from + place
            data(numbers[at / FileChunks.DATA], at % FileChunks.DATA).toByte()
        }
        return name to content
    }

    private fun name(first: Int, nameBytes: Int): String? {
        if (nameBytes !in 1..FileChunks.LONGEST_NAME) return null
        val bytes = ByteArray(nameBytes) { data(first, FileChunks.HEAD + it).toByte() }
        return bytes.decodeToString().takeIf { it.encodeToByteArray().contentEquals(bytes) }
    }

    /** The numbers of the chunks of a file; null if one does not lead back to the one before. */
    private fun chain(first: Int): List<Int>? {
        val numbers = mutableListOf(first)
        while (next(numbers.last()) != FileChunks.NONE) {
            val next = next(numbers.last())
            if (next !in 1..chunks || mark(next) != numbers.last() || numbers.size >= chunks) return null
            numbers += next
        }
        return numbers
    }

    private fun mark(number: Int) = bytes.u8((number - 1) * FileChunks.SIZE)

    private fun data(number: Int, place: Int) = bytes.u8((number - 1) * FileChunks.SIZE + 1 + place)

    private fun next(number: Int) = bytes.u8(number * FileChunks.SIZE - 1)
}
