package robotran.json

/** Whether the `Char` at index [offset] is an unpaired surrogate. */
internal fun isUnpairedSurrogate(text: String, offset: Int): Boolean {
    val character = text[offset]
    return (character.isHighSurrogate() && text.getOrNull(offset + 1)?.isLowSurrogate() != true) ||
        (character.isLowSurrogate() && text.getOrNull(offset - 1)?.isHighSurrogate() != true)
}

/** The four digits of [character] after `\u`. */
internal fun hexadecimal(character: Char): String = character.code.toString(radix = 16).padStart(UNICODE_DIGITS, '0')

private const val UNICODE_DIGITS = 4
