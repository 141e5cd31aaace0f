package robotran.textediting.text

import robotran.language.source.SourceSpan

/** Whether a name can contain [character], in Robolang or Java. */
internal fun isWordCharacter(character: Char): Boolean = character == '_' || character.isLetterOrDigit()

/** The word around [offset], which may be at its edge; null if there is none. */
fun wordAt(text: String, offset: Int): SourceSpan? {
    var start = offset
    while (start > 0 && isWordCharacter(text[start - 1])) start--
    var end = offset
    while (end < text.length && isWordCharacter(text[end])) end++
    return if (start < end) SourceSpan(start, end) else null
}

/** This text with the word, spaces or character at [offset] selected, as by a double click or long press. */
fun TextDocument.withWordSelected(offset: Int): TextDocument {
    val word = wordAt(text, offset) ?: blanksAt(text, offset) ?: return withCaret(offset)
    return copy(selection = TextSelection(word.start, word.end))
}

private fun blanksAt(text: String, offset: Int): SourceSpan? {
    var start = offset
    while (start > 0 && text[start - 1] == ' ') start--
    var end = offset
    while (end < text.length && text[end] == ' ') end++
    if (start < end) return SourceSpan(start, end)
    return if (offset < text.length &&
        text[offset] != '\n'
    ) {
        SourceSpan(offset, offset + widthAt(text, offset))
    } else {
        null
    }
}

/** The width of the character at [offset] in `Char`s: 2 for a surrogate pair. */
internal fun widthAt(text: String, offset: Int): Int =
    if (text[offset].isHighSurrogate() && offset + 1 < text.length && text[offset + 1].isLowSurrogate()) 2 else 1

/** The width of the character that ends at [offset] in `Char`s. */
internal fun widthBefore(text: String, offset: Int): Int =
    if (offset > 1 && text[offset - 1].isLowSurrogate() && text[offset - 2].isHighSurrogate()) 2 else 1
