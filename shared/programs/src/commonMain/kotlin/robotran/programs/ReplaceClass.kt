package robotran.programs

private const val CONSTANT_POOL = 10
private const val COUNT = 8
private const val BYTE_BITS = 8
private const val BYTE = 0xFF

private const val UTF8 = 1
private const val TWO_BYTES = 2
private const val FOUR_BYTES = 4
private const val EIGHT_BYTES = 8

/** The bytes of a constant behind its tag, but for text. Source: the Java Virtual Machine Specification, 4.4. */
private val CONSTANT_BYTES = mapOf(
    3 to FOUR_BYTES,
    4 to FOUR_BYTES,
    5 to EIGHT_BYTES,
    6 to EIGHT_BYTES,
    7 to TWO_BYTES,
    8 to TWO_BYTES,
    9 to FOUR_BYTES,
    10 to FOUR_BYTES,
    11 to FOUR_BYTES,
    12 to FOUR_BYTES,
)

/**
 * Returns [classFile], of version 45, with the class [to] wherever it names the class [from], for example as its
 * superclass. Both are internal names in ASCII.
 */
internal fun withClassReplaced(classFile: ByteArray, from: String, to: String): ByteArray {
    val text = from.encodeToByteArray()
    val constants = word(classFile, COUNT)
    var place = CONSTANT_POOL
    var index = 1
    while (index < constants) {
        val tag = classFile[place].toInt()
        if (tag == UTF8) {
            val length = word(classFile, place + 1)
            val start = place + 1 + TWO_BYTES
            if (classFile.copyOfRange(start, start + length).contentEquals(text)) {
                return classFile.copyOfRange(0, place + 1) + textConstant(to) +
                    classFile.copyOfRange(start + length, classFile.size)
            }
            place = start + length
        } else {
            place += 1 + CONSTANT_BYTES.getValue(tag)
        }
        index += if (CONSTANT_BYTES[tag] == EIGHT_BYTES) 2 else 1
    }
    error("The class file does not name $from.")
}

private fun textConstant(text: String): ByteArray {
    val bytes = text.encodeToByteArray()
    return byteArrayOf((bytes.size shr BYTE_BITS).toByte(), bytes.size.toByte()) + bytes
}

private fun word(bytes: ByteArray, offset: Int): Int =
    bytes[offset].toInt() and BYTE shl BYTE_BITS or (bytes[offset + 1].toInt() and BYTE)
