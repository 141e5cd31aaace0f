package robotran.language.pasted

import robotran.language.Language
import robotran.language.choose
import robotran.language.quoted

/** What pasted characters are called. */
internal enum class PastedCharacterKind(
    private val english: String,
    private val spanish: String,
    private val german: String,
    val isUnseen: Boolean = false,
) {
    QUOTATION_MARK("a curly quotation mark", "una comilla tipográfica", "ein typografisches Anführungszeichen"),
    DASH("a dash of a word processor", "un guion de procesador de textos", "ein Strich einer Textverarbeitung"),
    MATHEMATICAL("a mathematical sign", "un signo matemático", "ein mathematisches Zeichen"),
    WIDE("a wide character", "un carácter ancho", "ein breites Zeichen"),
    SPACE("a special space", "un espacio especial", "ein besonderes Leerzeichen", isUnseen = true),
    LINE_BREAK("a special line break", "un salto de línea especial", "ein besonderer Zeilenumbruch", isUnseen = true),
    INVISIBLE("an invisible character", "un carácter invisible", "ein unsichtbares Zeichen", isUnseen = true),
    ;

    fun nameIn(language: Language): String = language.choose(english, spanish, german)

    fun adviceIn(language: Language, character: Char, text: String): String {
        val name = nameIn(language)
        val code = unicodeNumber(character)
        val written = quoted(text)
        val plain = quoted(plainTextOf(text))
        return when (this) {
            SPACE -> language.choose(
                "Here is $name ($code). Put an ordinary space in its place.",
                "Aquí hay $name ($code). Pon en su lugar un espacio normal.",
                "Hier steht $name ($code). Setz ein gewöhnliches Leerzeichen dafür.",
            )

            LINE_BREAK -> language.choose(
                "Here is $name ($code). Put an ordinary line break in its place.",
                "Aquí hay $name ($code). Pon en su lugar un salto de línea normal.",
                "Hier steht $name ($code). Setz einen gewöhnlichen Zeilenumbruch dafür.",
            )

            INVISIBLE -> language.choose(
                "Here is $name ($code). Delete it.",
                "Aquí hay $name ($code). Bórralo.",
                "Hier steht $name ($code). Lösch es.",
            )

            else -> language.choose(
                "$written is $name. Write $plain.",
                "$written es $name. Escribe $plain.",
                "$written ist $name. Schreib $plain.",
            )
        }
    }

    companion object {
        /** The kind of a character that has to be written as [plain], except the wide ones. */
        fun of(plain: String): PastedCharacterKind = when (plain) {
            "\"", "'" -> QUOTATION_MARK
            "-" -> DASH
            " " -> SPACE
            "\n" -> LINE_BREAK
            else -> MATHEMATICAL
        }
    }
}

/** The code point of a character as Unicode writes it, such as `U+200B`. */
private fun unicodeNumber(character: Char): String =
    "U+" + character.code.toString(radix = 16).uppercase().padStart(4, '0')
