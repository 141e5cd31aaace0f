package robotran.json

/** Whether at [place] there is half of a character that takes two `Char`s, without the other half. */
internal fun isHalfCharacter(text: String, place: Int): Boolean {
    val character = text[place]
    return (character.isHighSurrogate() && text.getOrNull(place + 1)?.isLowSurrogate() != true) ||
        (character.isLowSurrogate() && text.getOrNull(place - 1)?.isHighSurrogate() != true)
}
