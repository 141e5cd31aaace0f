package robotran.legofirmware.image

/** Collects bytes; numbers have their low byte first. */
internal class ByteSink {
    private var bytes = ByteArray(INITIAL_SIZE)

    var size = 0
        private set

    /** Adds the low eight bits of [value]. */
    fun byte(value: Int) {
        if (size == bytes.size) bytes = bytes.copyOf(size * 2)
        bytes[size++] = value.toByte()
    }

    /** Adds the low 16 bits of [value]. */
    fun word(value: Int) {
        byte(value)
        byte(value shr Byte.SIZE_BITS)
    }

    fun toByteArray(): ByteArray = bytes.copyOf(size)

    private companion object {
        const val INITIAL_SIZE = 256
    }
}
