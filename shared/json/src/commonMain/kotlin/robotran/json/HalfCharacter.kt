package robotran.json

/** Whether the `Char` at index [place] is an unpaired surrogate. */
internal fun isUnpairedSurrogate(text: String, place: Int): Boolean {
    val character = text[place]
    return (character.isHighSurrogate() && text.getOrNull(place + 1)?.isLowSurrogate() != true) ||
        (character.isLowSurrogate() && text.getOrNull(place - 1)?.isHighSurrogate() != true)
}

/** The four digits of [character] after `\u`. */
internal fun hexadecimal(character: Char): String = character.code.toString(radix = 16).padStart(UNICODE_DIGITS, '0')

private const val UNICODE_DIGITS = 4
