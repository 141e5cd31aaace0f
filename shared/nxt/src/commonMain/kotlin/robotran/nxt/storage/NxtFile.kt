package robotran.nxt.storage

/**
 * A file in the flash memory of an NXT that a program has written; immutable.
 *
 * @property name at most [LONGEST_NAME] characters from 0 to 255.
 * @param bytes its content; must not change afterwards.
 * @property attributes bits: 1 read only, 2 hidden.
 */
class NxtFile(val name: String, private val bytes: ByteArray, val attributes: Int = 0) {
    /** The number of bytes. */
    val size: Int get() = bytes.size

    /** A copy of the content. */
    fun content(): ByteArray = bytes.copyOf()

    /** Copies the bytes from [from] up to before [to] into [target], at [place]. */
    internal fun copyInto(target: ByteArray, place: Int, from: Int, to: Int) {
        bytes.copyInto(target, place, from, to)
    }

    override fun equals(other: Any?): Boolean = other is NxtFile && name == other.name &&
        attributes == other.attributes && bytes.contentEquals(other.bytes)

    override fun hashCode(): Int = HASH_FACTOR * name.hashCode() + bytes.contentHashCode()

    override fun toString(): String = "$name ($size bytes)"

    companion object {
        const val LONGEST_NAME = 30
        private const val HASH_FACTOR = 31
    }
}
