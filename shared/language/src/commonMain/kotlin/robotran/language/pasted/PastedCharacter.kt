package robotran.language.pasted

import robotran.language.Language

/**
 * A character that comes into a program by copying it out of a word processor, a mail or a web page, where the keyboard
 * would have written another one.
 *
 * @property plain what to write instead; empty if the character has to be deleted.
 */
class PastedCharacter internal constructor(
    val character: Char,
    val plain: String,
    private val kind: PastedCharacterKind,
) {
    /** What it is, such as `a curly quotation mark`. */
    fun nameIn(language: Language): String = PastedCharacterMessages.of(language).name(kind)

    /**
     * What it is and what to write instead, in one or two sentences for a pupil.
     *
     * @param written more than this character, if what follows it was pasted, too.
     */
    fun adviceIn(language: Language, written: String = character.toString()): String =
        PastedCharacterMessages.of(language).advice(kind, unicodeNumber(character), written, plainTextOf(written))

    /** Whether it cannot be seen, or not be told from an ordinary space or line end. */
    val isUnseen: Boolean get() = kind.isUnseen

    /** Whether it stands in the place of a space or of a line end. */
    val isBlank: Boolean get() = plain.isNotEmpty() && plain.isBlank()
}

/** What [character] is, if programs get it by copying only; null for all others. */
fun pastedCharacter(character: Char): PastedCharacter? {
    if (character < FIRST_OTHER) return LINE_BREAK.takeIf { it == character }?.let { pastedAs(it, "\n") }
    return WITH_PLAIN[character] ?: wideCharacter(character) ?: invisibleCharacter(character)
}

/** The code point of a character as Unicode writes it, such as `U+200B`. */
private fun unicodeNumber(character: Char): String =
    "U+" + character.code.toString(radix = 16).uppercase().padStart(4, '0')

/** This text with all its pasted characters as the keyboard writes them. */
fun plainTextOf(text: String): String = buildString {
    for (character in text) append(pastedCharacter(character)?.plain ?: character)
}

/** Characters below are on every keyboard, but for [LINE_BREAK]. */
private const val FIRST_OTHER = '\u0080'
private const val LINE_BREAK = '\u000B'

/** The distance of the characters that are as wide as a Chinese one from their plain ones. */
private const val WIDE_OFFSET = 0xFEE0
private val WIDE_CHARACTERS = '\uFF01'..'\uFF5E'

private val INVISIBLE_CHARACTERS = listOf(
    '\u0080'..'\u009F',
    '\u00AD'..'\u00AD',
    '\u034F'..'\u034F',
    '\u061C'..'\u061C',
    '\u180E'..'\u180E',
    '\u200B'..'\u200F',
    '\u202A'..'\u202E',
    '\u2060'..'\u206F',
    '\uFE00'..'\uFE0F',
    '\uFEFF'..'\uFEFF',
    '\uFFF9'..'\uFFFB',
)

private val WITH_PLAIN: Map<Char, PastedCharacter> = listOf(
    "\"" to "\u201C\u201D\u201E\u201F\u00AB\u00BB\u2033\u301D\u301E\u301F",
    "'" to "\u2018\u2019\u201A\u201B\u2039\u203A\u2032\u00B4",
    "-" to "\u2010\u2011\u2012\u2013\u2014\u2015\u2212\uFE58\uFE63",
    " " to "\u00A0\u1680\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200A\u202F\u205F\u3000",
    "\n" to "\u0085\u2028\u2029",
    "<=" to "\u2264\u2266\u2A7D",
    ">=" to "\u2265\u2267\u2A7E",
    "!=" to "\u2260",
    "*" to "\u00D7\u00B7\u2217\u2219\u22C5",
    "/" to "\u00F7\u2044\u2215",
).flatMap { (plain, characters) -> characters.map { it to pastedAs(it, plain) } }.toMap()

private fun pastedAs(character: Char, plain: String) = PastedCharacter(character, plain, PastedCharacterKind.of(plain))

private fun wideCharacter(character: Char): PastedCharacter? = character.takeIf { it in WIDE_CHARACTERS }
    ?.let { PastedCharacter(it, (it - WIDE_OFFSET).toString(), PastedCharacterKind.WIDE) }

private fun invisibleCharacter(character: Char): PastedCharacter? =
    character.takeIf { INVISIBLE_CHARACTERS.any { range -> it in range } }
        ?.let { PastedCharacter(it, "", PastedCharacterKind.INVISIBLE) }
