package robotran.languagesupport

import robotran.brick.kind.BrickKind

/**
 * The tokens of the lines of a program, computed on demand.
 *
 * @param otherwise the brick of a program that does not name one.
 */
class CodeTokens(private val lines: TextLines, private val syntax: CodeSyntax, otherwise: BrickKind) {
    private val brick = syntax.brickOf(lines) ?: otherwise
    private val startsInComment: BooleanArray? by lazy(LazyThreadSafetyMode.PUBLICATION) { commentStarts() }

    /** Whether [line], from 0, begins inside a comment of several lines. */
    fun startsInComment(line: Int): Boolean = startsInComment?.get(line) ?: false

    /** The tokens of [line], from 0. */
    fun of(line: Int): List<CodeToken> = syntax.tokens(lines.line(line), startsInComment(line), brick).tokens

    private fun commentStarts(): BooleanArray? {
        if (!syntax.hasLongComments || "/*" !in lines.text) return null
        val starts = BooleanArray(lines.count)
        var inComment = false
        for (line in 0..<lines.count) {
            starts[line] = inComment
            val text = lines.line(line)
            if (inComment || "/*" in text) inComment = syntax.tokens(text, inComment, brick).endsInComment
        }
        return starts
    }
}
