package robotran.animatedpicture

/** Collects the bytes of a file. */
internal class ByteSink {
    private var bytes = ByteArray(INITIAL)

    var size = 0
        private set

    fun byte(value: Int) {
        if (size == bytes.size) bytes = bytes.copyOf(size * 2)
        bytes[size++] = value.toByte()
    }

    /** Two bytes, the lower one first. */
    fun short(value: Int) {
        byte(value)
        byte(value shr BITS_PER_BYTE)
    }

    fun text(ascii: String) = ascii.forEach { byte(it.code) }

    /** The first [count] of [block]. */
    fun block(block: ByteArray, count: Int) {
        while (size + count > bytes.size) bytes = bytes.copyOf(bytes.size * 2)
        block.copyInto(bytes, size, 0, count)
        size += count
    }

    fun toByteArray(): ByteArray = bytes.copyOf(size)

    private companion object {
        const val INITIAL = 65_536
    }
}

internal const val BITS_PER_BYTE = 8
