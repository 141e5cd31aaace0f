package robotran.nqc.syntax

import robotran.language.source.SourceRange

/**
 * A word, number or sign of a program.
 *
 * @property text as typed; the content for a [TokenKind.TEXT], the word after `#` for a [TokenKind.DIRECTIVE].
 * @property range where it is; for a token from a macro, where the macro is used.
 * @property value of a number.
 * @property isSeparate whether a blank or comment is before it.
 * @property macro the macro that it comes from; null if it is typed.
 * @property definedAt where it is typed in the definition of that macro; null if it is in none.
 */
internal data class Token(
    val kind: TokenKind,
    val text: String,
    val range: SourceRange,
    val value: Int = 0,
    val isSeparate: Boolean = false,
    val macro: MacroUse? = null,
    val definedAt: SourceRange? = null,
) {
    val keyword: Keyword? get() = if (kind == TokenKind.KEYWORD) Keyword.of(text) else null

    fun isSign(sign: String): Boolean = kind == TokenKind.SIGN && text == sign
}

/**
 * The use of a macro [name] within the one of [parent].
 *
 * @property end the last token of the use: its name, or the bracket that closes its arguments.
 */
internal class MacroUse(val name: String, val parent: MacroUse?, val end: SourceRange) {
    val depth: Int = 1 + (parent?.depth ?: 0)

    /** The use that the program shows. */
    val outermost: MacroUse
        get() {
            var use = this
            while (true) use = use.parent ?: return use
        }

    /** Whether this use or one around it is of the macro [name]. */
    fun isWithin(name: String): Boolean {
        var use: MacroUse? = this
        while (use != null) {
            if (use.name == name) return true
            use = use.parent
        }
        return false
    }
}

internal enum class TokenKind { NAME, KEYWORD, NUMBER, TEXT, SIGN, DIRECTIVE, END_OF_DIRECTIVE, UNKNOWN, END }
