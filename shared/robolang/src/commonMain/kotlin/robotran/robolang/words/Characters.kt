package robotran.robolang.words

/*
 * Character classes of the scanner. They do not use the platforms' tables, which belong to different versions of
 * Unicode, because a program must compile the same everywhere.
 */

private const val NO_BREAK_SPACE = '\u00A0'
private const val MULTIPLICATION_SIGN = '\u00D7'
private const val DIVISION_SIGN = '\u00F7'
private val LATIN_LETTERS = '\u00C0'..'\u024F'
private val GREEK_AND_CYRILLIC_LETTERS = '\u0370'..'\u04FF'

internal fun isBlank(character: Char): Boolean =
    character == ' ' || character == '\t' || character == '\u000C' || character == NO_BREAK_SPACE

internal fun isDigit(character: Char): Boolean = character in '0'..'9'

/** Whether a character is a letter of an alphabet that names may use. */
internal fun isLetter(character: Char): Boolean = character in 'a'..'z' || character in 'A'..'Z' || character == '_' ||
    (character in LATIN_LETTERS && character != MULTIPLICATION_SIGN && character != DIVISION_SIGN) ||
    character in GREEK_AND_CYRILLIC_LETTERS

/** Whether a character is invisible, such as a control character, a joiner or half of a surrogate pair. */
internal fun isInvisible(character: Char): Boolean =
    character < ' ' || character in '\u007F'..'\u00A0' || character == '\u00AD' ||
        character in '\u2000'..'\u200F' || character in '\u2028'..'\u202F' || character in '\u205F'..'\u206F' ||
        character == '\u3000' || character.isSurrogate() || character in '\uFE00'..'\uFE0F' || character == '\uFEFF' ||
        character >= '\uFFF0'

/** The code point of a character as Unicode writes it, such as `U+200B`. */
internal fun unicodeNumber(character: Char): String =
    "U+" + character.code.toString(radix = 16).uppercase().padStart(4, '0')
