package robotran.microbitlink.files

import robotran.microbitlink.ImageError

/** The name of the file that MicroPython starts with. */
const val MAIN_FILE = "main.py"

/**
 * How much room a board has for files.
 *
 * @property chunks pieces of 128 bytes, of which a file takes whole ones.
 */
data class FileRoom(val chunks: Int) {
    /** All of it. */
    val bytes: Int get() = chunks * FileChunks.SIZE

    /** The largest program that fits as [MAIN_FILE] alone. */
    val largestMain: Int get() = FileChunks.largest(MAIN_FILE.length, chunks)

    /** How much of [bytes] the [files] take. */
    fun used(files: Map<String, ByteArray>): Int = files.entries.sumOf { chunks(it) } * FileChunks.SIZE

    /** Why [files] cannot be there; null if they can. */
    fun mistake(files: Map<String, ByteArray>): ImageError? {
        for ((name, content) in files) {
            if (name.encodeToByteArray().size !in 1..FileChunks.LONGEST_NAME) return ImageError.BadName(name)
            if (content.isEmpty()) return ImageError.EmptyFile(name)
        }
        if (files.entries.sumOf { chunks(it) } <= chunks) return null
        return ImageError.TooLarge(files.values.sumOf { it.size }, most(files))
    }

    /** How many bytes these files may have together if the largest of them is made smaller. */
    private fun most(files: Map<String, ByteArray>): Int {
        val largest = files.entries.maxBy { it.value.size }
        val others = files.entries.filter { it.key != largest.key }
        val left = chunks - others.sumOf { chunks(it) }
        if (left <= 0) return bytes
        return FileChunks.largest(largest.key.encodeToByteArray().size, left) + others.sumOf { it.value.size }
    }

    private fun chunks(file: Map.Entry<String, ByteArray>): Int =
        FileChunks.count(file.key.encodeToByteArray().size, file.value.size)
}
