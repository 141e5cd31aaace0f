package robotran.textediting.code

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.robolang.SourceTokenKind
import robotran.robolang.robolangTokens
import robotran.textediting.text.TextLines

/**
 * The tokens of the lines of a program, computed on demand.
 *
 * @param otherwise the brick of a Java program that does not name one.
 */
class CodeTokens(
    private val lines: TextLines,
    private val language: ProgramLanguage,
    otherwise: BrickKind = BrickKind.RCX,
) {
    private val brick = if (language == ProgramLanguage.JAVA) brickOfJava(lines, otherwise) else otherwise
    private val startsInComment: BooleanArray? by lazy(LazyThreadSafetyMode.PUBLICATION) { commentStarts() }

    /** Whether [line], from 0, begins inside a comment of several lines. */
    fun startsInComment(line: Int): Boolean = startsInComment?.get(line) ?: false

    /** The tokens of [line], from 0. */
    fun of(line: Int): List<CodeToken> = tokensOf(lines.line(line), language, startsInComment(line), brick)

    private fun commentStarts(): BooleanArray? {
        if (language == ProgramLanguage.ROBOLANG || "/*" !in lines.text) return null
        val starts = BooleanArray(lines.count)
        var inComment = false
        for (line in 0..<lines.count) {
            starts[line] = inComment
            val text = lines.line(line)
            if (inComment || "/*" in text) inComment = tokenizeJavaLine(text, inComment).endsInComment
        }
        return starts
    }
}

/** The tokens of one [line] of a program for a [brick]. Never throws for any input. */
fun tokensOf(
    line: String,
    language: ProgramLanguage,
    startsInComment: Boolean,
    brick: BrickKind = BrickKind.RCX,
): List<CodeToken> = when (language) {
    ProgramLanguage.ROBOLANG -> robolangTokens(line).map { CodeToken(kindOf(it.kind), it.start, it.end) }
    ProgramLanguage.JAVA -> tokenizeJavaLine(line, startsInComment, brick).tokens
}

private fun kindOf(kind: SourceTokenKind): CodeTokenKind = when (kind) {
    SourceTokenKind.KEYWORD -> CodeTokenKind.KEYWORD
    SourceTokenKind.BUILT_IN -> CodeTokenKind.BUILT_IN
    SourceTokenKind.NAME -> CodeTokenKind.NAME
    SourceTokenKind.NUMBER -> CodeTokenKind.NUMBER
    SourceTokenKind.TEXT -> CodeTokenKind.TEXT
    SourceTokenKind.SIGN -> CodeTokenKind.SIGN
    SourceTokenKind.COMMENT -> CodeTokenKind.COMMENT
}
