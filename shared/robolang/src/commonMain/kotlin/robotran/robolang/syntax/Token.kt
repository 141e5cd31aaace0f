package robotran.robolang.syntax

import robotran.robolang.SourceRange

/** The smallest pieces a line is made of. */
internal enum class TokenKind { WORD, NUMBER, MINUS, COMMA, COMMENT }

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
)

/**
 * One line of the source, in pieces.
 *
 * @property number from 1.
 * @property text the whole line without its line end.
 * @property tokens what counts.
 * @property comment what does not, but must not get lost: always the last thing on a line.
 * @property mistaken true if a mistake on this line has been reported already, so that nothing that follows from it is.
 */
internal data class ScannedLine(
    val number: Int,
    val text: String,
    val tokens: List<Token>,
    val comment: Token?,
    val mistaken: Boolean,
)
