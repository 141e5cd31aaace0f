package robotran.hublink.output

/** Decodes UTF-8 that comes in pieces, which may end within a letter. */
internal class TextDecoder {
    private var rest = ByteArray(0)

    /** The letters that are whole with [bytes]. What is no UTF-8 becomes a replacement character. */
    fun add(bytes: ByteArray): String {
        val all = rest + bytes
        val whole = all.size - unfinished(all)
        rest = all.copyOfRange(whole, all.size)
        return all.decodeToString(0, whole)
    }

    /** How many bytes at the end of [bytes] begin a letter whose other bytes are missing. */
    private fun unfinished(bytes: ByteArray): Int {
        for (back in 1..minOf(bytes.size, LONGEST - 1)) {
            val byte = bytes[bytes.size - back].toInt() and 0xFF
            val length = when {
                byte and 0xE0 == 0xC0 -> 2
                byte and 0xF0 == 0xE0 -> 3
                byte and 0xF8 == 0xF0 -> LONGEST
                byte and 0xC0 == 0x80 -> continue
                else -> 1
            }
            return if (length > back) back else 0
        }
        return 0
    }

    private companion object {
        const val LONGEST = 4
    }
}
