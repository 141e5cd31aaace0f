package robotran.robolang.syntax

import robotran.language.source.SourceRange
import robotran.robolang.words.Keyword

/**
 * The kinds of tokens.
 *
 * @property text its fixed spelling; null if it varies.
 */
internal enum class TokenKind(val text: String? = null) {
    WORD,
    NUMBER,

    /** A text for the LCD, with its quotation marks. */
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
        /** The kinds with a fixed spelling, longest first. */
        val SIGNS: List<TokenKind> = entries.filter { it.text != null }
    }
}

/**
 * A token.
 *
 * @property text as typed.
 * @property keyword the keyword, if [text] is one.
 */
internal data class Token(
    val kind: TokenKind,
    val range: SourceRange,
    val text: String,
    val keyword: Keyword? = null,
) {
    /** Whether it can be a name. A single letter can, also where it is an operator behind a value: Spanish `y`. */
    val canBeName: Boolean
        get() = kind == TokenKind.WORD && (keyword == null || keyword.isFree || text.length == 1)
}

/**
 * The tokens of one source line.
 *
 * @property number from 1.
 * @property text the whole line without its line end.
 * @property tokens without the comment.
 * @property comment the comment at the end of the line; null if there is none.
 */
internal data class ScannedLine(val number: Int, val text: String, val tokens: List<Token>, val comment: Token?)
