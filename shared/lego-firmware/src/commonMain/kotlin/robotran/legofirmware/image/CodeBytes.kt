package robotran.legofirmware.image

/** Immutable bytes of code, each 0..255, compared by content. */
class CodeBytes(bytes: ByteArray) {
    private val bytes = bytes.copyOf()

    val size: Int get() = bytes.size

    /** The byte at [address], from 0, as 0..255. */
    operator fun get(address: Int): Int = bytes[address].toInt() and BYTE_MASK

    fun toByteArray(): ByteArray = bytes.copyOf()

    override fun equals(other: Any?): Boolean = other is CodeBytes && bytes.contentEquals(other.bytes)

    override fun hashCode(): Int = bytes.contentHashCode()

    /** The bytes as two hexadecimal digits each, separated by blanks. */
    override fun toString(): String = bytes.joinToString(" ") { hexByte(it.toInt() and BYTE_MASK) }

    companion object {
        private const val BYTE_MASK = 0xFF

        /** The low eight bits of each number. */
        fun of(vararg numbers: Int): CodeBytes = CodeBytes(ByteArray(numbers.size) { numbers[it].toByte() })
    }
}

private const val HEX_RADIX = 16

/** A byte 0..255 as two hexadecimal digits in lower case. */
internal fun hexByte(byte: Int): String = byte.toString(HEX_RADIX).padStart(2, '0')
