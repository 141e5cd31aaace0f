package robotran.robolang.syntax

import robotran.robolang.diagnostic.SourceRange

/**
 * The smallest pieces a line is made of.
 *
 * @property text how it is always spelled, null where that differs.
 */
internal enum class TokenKind(val text: String? = null) {
    WORD,
    NUMBER,

    /** Letters for the LCD, with the quotation marks around them. */
    TEXT,

    EQUAL("=="),
    NOT_EQUAL("!="),
    LESS_OR_EQUAL("<="),
    GREATER_OR_EQUAL(">="),
    LESS("<"),
    GREATER(">"),
    ASSIGN("="),
    PLUS("+"),
    MINUS("-"),
    TIMES("*"),
    DIVIDE("/"),
    COMMA(","),
    OPEN_BRACKET("("),
    CLOSE_BRACKET(")"),
    OPEN_LIST("["),
    CLOSE_LIST("]"),
    COMMENT,
    ;

    companion object {
        /** Those that are always spelled alike, the longer ones first. */
        val SIGNS: List<TokenKind> = entries.filter { it.text != null }
    }
}

/**
 * One piece of a line.
 *
 * @property text as it was typed.
 * @property keyword what [text] means if it is a word of the language.
 */
internal data class Token(
    val kind: TokenKind,
    val range: SourceRange,
    val text: String,
    val keyword: Keyword? = null,
) {
    /** Whether a pupil may call something so. */
    val canBeName: Boolean
        get() = kind == TokenKind.WORD && (keyword == null || keyword.isFree)
}

/**
 * One line of the source, in pieces.
 *
 * @property number from 1.
 * @property text the whole line without its line end.
 * @property tokens what counts.
 * @property comment what does not, but must not get lost: always the last thing on a line.
 */
internal data class ScannedLine(val number: Int, val text: String, val tokens: List<Token>, val comment: Token?)
