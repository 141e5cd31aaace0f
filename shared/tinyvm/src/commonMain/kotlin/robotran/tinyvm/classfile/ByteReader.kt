package robotran.tinyvm.classfile

/**
 * Thrown at the first malformed byte, also when a reader later looks up a constant that is missing or of another kind.
 * [readClassFile] catches its own; other users of a [ClassFile] must catch it.
 */
class DamagedClassFile(val reason: String) : RuntimeException(reason)

internal fun damaged(reason: String): Nothing = throw DamagedClassFile(reason)

/** Reads big-endian numbers from [bytes] between [position] and [end]; throws [DamagedClassFile] beyond the end. */
internal class ByteReader(private val bytes: ByteArray, var position: Int = 0, val end: Int = bytes.size) {
    val isAtEnd: Boolean get() = position == end

    fun unsignedByte(): Int {
        need(1)
        return bytes[position++].toInt() and 0xFF
    }

    fun signedByte(): Int = unsignedByte().toByte().toInt()

    fun unsignedShort(): Int {
        need(2)
        return unsignedByte() shl 8 or unsignedByte()
    }

    fun signedShort(): Int = unsignedShort().toShort().toInt()

    fun int(): Int {
        need(4)
        return unsignedShort() shl 16 or unsignedShort()
    }

    /** Reads a length, which must not exceed the remaining bytes. */
    fun length(): Int {
        val length = int()
        if (length < 0 || length > end - position) damaged("a length beyond the end")
        return length
    }

    /** Returns a reader for the next [length] bytes. */
    fun part(length: Int): ByteReader {
        need(length)
        val part = ByteReader(bytes, position, position + length)
        position += length
        return part
    }

    fun copy(length: Int): ByteArray {
        need(length)
        position += length
        return bytes.copyOfRange(position - length, position)
    }

    private fun need(length: Int) {
        if (length < 0 || length > end - position) damaged("the file ends too early")
    }
}
