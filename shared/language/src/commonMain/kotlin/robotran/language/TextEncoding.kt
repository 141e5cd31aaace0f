package robotran.language

/** @property ownName what people know it by. */
enum class TextEncoding(val ownName: String) {
    UTF_8("UTF-8"),

    /** What Windows of western Europe wrote for decades, and some of its programs still do. */
    WINDOWS_1252("Windows-1252"),

    /** With either byte first, as Notepad and PowerShell write it. */
    UTF_16("UTF-16"),
}

/** @property text without a byte order mark. */
class DecodedText(val text: String, val encoding: TextEncoding)

/**
 * The text of a file with these [bytes]: in UTF-8, or in UTF-16 where that is unmistakable, by a byte order mark or
 * because every other byte is 0, or else in Windows-1252. Null if it is no text in any of these.
 */
fun decodeText(bytes: ByteArray): DecodedText? {
    val hasMark = bytes.size >= 2 && unit(bytes, 0, isLittle = true) in MARKS
    val isLittle = if (hasMark) unit(bytes, 0, isLittle = true) == MARK else looksLittle(bytes)
    if (isLittle != null) return utf16(bytes, isLittle)?.let { DecodedText(it, TextEncoding.UTF_16) }
    return try {
        DecodedText(bytes.decodeToString(throwOnInvalidSequence = true).removePrefix("\uFEFF"), TextEncoding.UTF_8)
    } catch (_: CharacterCodingException) {
        windowsText(bytes)?.let { DecodedText(it, TextEncoding.WINDOWS_1252) }
    }
}

/** Whether text without a mark is in UTF-16 with the lower byte first; null if it does not look like UTF-16. */
private fun looksLittle(bytes: ByteArray): Boolean? {
    val units = bytes.size / 2
    if (units < SURE_UNITS || bytes.size % 2 != 0) return null
    val zeroFirst = (bytes.indices step 2).count { bytes[it] == ZERO }
    val zeroSecond = (1..<bytes.size step 2).count { bytes[it] == ZERO }
    // In programs nearly all characters are below 256; no text has the character 0.
    return when {
        zeroFirst == 0 && zeroSecond > units / 2 -> true
        zeroSecond == 0 && zeroFirst > units / 2 -> false
        else -> null
    }
}

private fun utf16(bytes: ByteArray, isLittle: Boolean): String? {
    if (bytes.size % 2 != 0) return null
    val text = CharArray(bytes.size / 2) { unit(bytes, 2 * it, isLittle).toChar() }.concatToString()
        .removePrefix("\uFEFF")
    val isWhole = text.indices.all { place ->
        when {
            text[place].isHighSurrogate() -> text.getOrNull(place + 1)?.isLowSurrogate() == true
            text[place].isLowSurrogate() -> text.getOrNull(place - 1)?.isHighSurrogate() == true
            else -> true
        }
    }
    return text.takeIf { isWhole && isOrdinary(it) }
}

private fun unit(bytes: ByteArray, offset: Int, isLittle: Boolean): Int {
    val first = bytes[offset].toInt() and BYTE
    val second = bytes[offset + 1].toInt() and BYTE
    return if (isLittle) second * BYTES + first else first * BYTES + second
}

private fun windowsText(bytes: ByteArray): String? {
    val characters = CharArray(bytes.size) { index ->
        val code = bytes[index].toInt() and BYTE
        if (code in HIGH) HIGH_CHARACTERS[code - HIGH.first] else code.toChar()
    }
    return characters.concatToString().takeIf(::isOrdinary)
}

/** Whether [text] has no control characters but blanks, which files of another kind have. */
private fun isOrdinary(text: String): Boolean = text.none { it < ' ' && it !in BLANKS }

private const val ZERO: Byte = 0
private const val BYTE = 0xFF
private const val BYTES = 0x100

/** The byte order mark, read with the lower byte first, and the same turned around. */
private const val MARK = 0xFEFF
private val MARKS = setOf(MARK, 0xFFFE)

/** Fewer could be anything. */
private const val SURE_UNITS = 2

/** The last one ends files of DOS. */
private const val BLANKS = "\t\n\u000B\u000C\r\u001A"

/** The bytes in which Windows-1252 is not Latin-1. */
private val HIGH = 0x80..0x9F

/** Their characters; those of no character stand for themselves. */
private const val HIGH_CHARACTERS =
    "\u20AC\u0081\u201A\u0192\u201E\u2026\u2020\u2021\u02C6\u2030\u0160\u2039\u0152\u008D\u017D\u008F" +
        "\u0090\u2018\u2019\u201C\u201D\u2022\u2013\u2014\u02DC\u2122\u0161\u203A\u0153\u009D\u017E\u0178"
