package robotran.tinyvm.classfile

/** Decodes the modified UTF-8 of a text constant: each UTF-16 unit is encoded by itself, and 0 takes two bytes. */
internal fun readModifiedUtf8(reader: ByteReader): String {
    val text = StringBuilder()
    while (!reader.isAtEnd) {
        val first = reader.unsignedByte()
        val unit = when {
            first in 0x01..0x7F -> first
            first shr 5 == 0b110 -> first and 0x1F shl 6 or continuation(reader)
            first shr 4 == 0b1110 -> first and 0x0F shl 12 or (continuation(reader) shl 6) or continuation(reader)
            else -> damaged("a text with a wrong byte")
        }
        text.append(unit.toChar())
    }
    return text.toString()
}

private fun continuation(reader: ByteReader): Int {
    val byte = reader.unsignedByte()
    if (byte shr 6 != 0b10) damaged("a text with a wrong byte")
    return byte and 0x3F
}
