package robotran.languagesupport

/**
 * A token of a line of code.
 *
 * @property start its first column, from 0.
 * @property end the column behind its last character.
 */
data class CodeToken(val kind: CodeTokenKind, val start: Int, val end: Int)

/** The kinds of tokens that have a colour of their own. */
enum class CodeTokenKind {
    KEYWORD,

    /** A built-in function or a library class. */
    BUILT_IN,
    NAME,
    NUMBER,
    TEXT,
    SIGN,
    COMMENT,
}

/**
 * The tokens of a line of code. Blanks and unknown characters are in none.
 *
 * @property endsInComment whether the next line begins inside a comment.
 */
data class LineTokens(val tokens: List<CodeToken>, val endsInComment: Boolean)
