package robotran.textediting.code

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.nqc.edit.NqcTokenKind
import robotran.nqc.edit.nqcTokens
import robotran.robolang.SourceTokenKind
import robotran.robolang.robolangTokens
import robotran.textediting.text.TextLines

/**
 * The tokens of the lines of a program, computed on demand.
 *
 * @param otherwise the brick of a Java program that does not name one.
 */
class CodeTokens(private val lines: TextLines, private val language: ProgramLanguage, otherwise: BrickKind) {
    private val brick = if (language == ProgramLanguage.JAVA) brickOfJava(lines, otherwise) else otherwise
    private val startsInComment: BooleanArray? by lazy(LazyThreadSafetyMode.PUBLICATION) { commentStarts() }

    /** Whether [line], from 0, begins inside a comment of several lines. */
    fun startsInComment(line: Int): Boolean = startsInComment?.get(line) ?: false

    /** The tokens of [line], from 0. */
    fun of(line: Int): List<CodeToken> = tokensOf(lines.line(line), language, startsInComment(line), brick)

    private fun commentStarts(): BooleanArray? {
        if (language !in WITH_LONG_COMMENTS || "/*" !in lines.text) return null
        val starts = BooleanArray(lines.count)
        var inComment = false
        for (line in 0..<lines.count) {
            starts[line] = inComment
            val text = lines.line(line)
            if (inComment || "/*" in text) inComment = endsInComment(text, inComment)
        }
        return starts
    }

    private fun endsInComment(line: String, startsInComment: Boolean): Boolean = when (language) {
        ProgramLanguage.NQC -> nqcTokens(line, startsInComment).endsInComment
        else -> tokenizeJavaLine(line, startsInComment, brick).endsInComment
    }

    private companion object {
        val WITH_LONG_COMMENTS = setOf(ProgramLanguage.JAVA, ProgramLanguage.NQC)
    }
}

/** The tokens of one [line] of a program for a [brick]. Never throws for any input. */
fun tokensOf(line: String, language: ProgramLanguage, startsInComment: Boolean, brick: BrickKind): List<CodeToken> =
    when (language) {
        ProgramLanguage.ROBOLANG -> robolangTokens(line).map { CodeToken(kindOf(it.kind), it.start, it.end) }
        ProgramLanguage.JAVA -> tokenizeJavaLine(line, startsInComment, brick).tokens
        ProgramLanguage.NQC -> nqcTokens(line, startsInComment).tokens.map {
            CodeToken(kindOf(it.kind), it.start, it.end)
        }
        ProgramLanguage.LASM -> tokenizeLasmLine(line)
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

private fun kindOf(kind: NqcTokenKind): CodeTokenKind = when (kind) {
    NqcTokenKind.KEYWORD, NqcTokenKind.DIRECTIVE -> CodeTokenKind.KEYWORD
    NqcTokenKind.BUILT_IN -> CodeTokenKind.BUILT_IN
    NqcTokenKind.NAME -> CodeTokenKind.NAME
    NqcTokenKind.NUMBER -> CodeTokenKind.NUMBER
    NqcTokenKind.TEXT -> CodeTokenKind.TEXT
    NqcTokenKind.SIGN -> CodeTokenKind.SIGN
    NqcTokenKind.COMMENT -> CodeTokenKind.COMMENT
}
