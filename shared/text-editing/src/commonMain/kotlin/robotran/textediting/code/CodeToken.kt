package robotran.textediting.code

/**
 * A word, a number or a sign of a line of code.
 *
 * @property start its first column, from 0.
 * @property end the column behind its last character.
 */
data class CodeToken(val kind: CodeTokenKind, val start: Int, val end: Int)

/** What pieces of code are told apart by their colours. */
enum class CodeTokenKind {
    /** A word of the language. */
    KEYWORD,

    /** A function or a class that is already there. */
    KNOWN,
    NAME,
    NUMBER,
    TEXT,
    SIGN,
    COMMENT,
}

/**
 * A line of code in pieces; blanks, and what the language does not know, are in none.
 *
 * @property endsInComment whether the next line begins inside a comment.
 */
data class LinePieces(val pieces: List<CodeToken>, val endsInComment: Boolean)
