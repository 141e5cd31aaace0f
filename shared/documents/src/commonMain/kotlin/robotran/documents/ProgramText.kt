package robotran.documents

import robotran.language.ProgramLanguage

/**
 * The text of the file [name] with these [bytes], without a byte order mark; null if it is no text. A text is in UTF-8;
 * one in NQC may also be in Windows-1252, since most programs in it are from before UTF-8.
 */
fun programText(name: String, bytes: ByteArray): String? = try {
    bytes.decodeToString(throwOnInvalidSequence = true).removePrefix("\uFEFF")
} catch (_: CharacterCodingException) {
    val isNqc = ProgramLanguage.ofFile(name) == ProgramLanguage.NQC ||
        name.endsWith(FileKind.NQC_HEADER.extension, ignoreCase = true)
    if (isNqc) windowsText(bytes) else null
}

private fun windowsText(bytes: ByteArray): String? {
    val characters = CharArray(bytes.size) { index ->
        val code = bytes[index].toInt() and BYTE
        if (code in HIGH) HIGH_CHARACTERS[code - HIGH.first] else code.toChar()
    }
    return characters.concatToString().takeIf { text -> text.none { it < ' ' && it !in BLANKS } }
}

private const val BYTE = 0xFF

/** The last one ends files of DOS. */
private const val BLANKS = "\t\n\u000B\u000C\r\u001A"

/** The bytes in which Windows-1252 is not Latin-1. */
private val HIGH = 0x80..0x9F

/** Their characters; those of no character stand for themselves. */
private const val HIGH_CHARACTERS =
    "\u20AC\u0081\u201A\u0192\u201E\u2026\u2020\u2021\u02C6\u2030\u0160\u2039\u0152\u008D\u017D\u008F" +
        "\u0090\u2018\u2019\u201C\u201D\u2022\u2013\u2014\u02DC\u2122\u0161\u203A\u0153\u009D\u017E\u0178"
