package robotran.javacompiler.edit

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.languagesupport.CodeToken
import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.LineTokens

/** The reserved words and literals of Java 1.3. */
internal val JAVA_KEYWORDS: List<String> = (
    "abstract boolean break byte case catch char class const continue default do double else extends false final " +
        "finally float for " +
        "goto if implements import instanceof int interface long native new null package private protected public " +
        "return short static " +
        "super switch synchronized this throw throws transient true try void volatile while"
).split(' ')

/**
 * Splits one [line] of Java into tokens. Never throws for any input.
 *
 * @param startsInComment whether the line begins inside a comment.
 * @param brick the brick that the program is for; null if the names of its classes do not matter.
 */
internal fun tokenizeJavaLine(line: String, startsInComment: Boolean, brick: BrickKind?): LineTokens = JavaLine(
    line,
    startsInComment,
    brick?.let { BrickApi.of(it).classNames }.orEmpty(),
    brick?.let(::keywordsFor) ?: KEYWORDS,
).tokens()

private class JavaLine(
    private val line: String,
    private var isInComment: Boolean,
    private val classes: Set<String>,
    private val keywords: Set<String>,
) {
    private val tokens = mutableListOf<CodeToken>()
    private var position = 0

    fun tokens(): LineTokens {
        if (isInComment) takeComment(0)
        while (position < line.length) token()
        return LineTokens(tokens, isInComment)
    }

    private fun token() {
        val character = line[position]
        when {
            character.isWhitespace() -> position++
            isNameStart(character) -> takeWord()
            character.isDigit() || (character == '.' && line.getOrNull(position + 1)?.isDigit() == true) -> takeNumber()
            character == '"' || character == '\'' -> takeText(character)
            line.startsWith("//", position) -> take(CodeTokenKind.COMMENT, line.length)
            line.startsWith("/*", position) -> takeComment("/*".length)
            else -> take(CodeTokenKind.SIGN, position + 1)
        }
    }

    private fun takeWord() {
        val end = endOf { isNamePart(it) }
        val word = line.substring(position, end)
        val kind = when (word) {
            in keywords -> CodeTokenKind.KEYWORD
            in classes -> CodeTokenKind.BUILT_IN
            else -> CodeTokenKind.NAME
        }
        take(kind, end)
    }

    private fun takeNumber() = take(CodeTokenKind.NUMBER, endOf { it.isLetterOrDigit() || it == '.' })

    private fun takeText(mark: Char) {
        var end = position + 1
        while (end < line.length && line[end] != mark) end += if (line[end] == '\\') 2 else 1
        take(CodeTokenKind.TEXT, minOf(end + 1, line.length))
    }

    private fun takeComment(opening: Int) {
        val close = line.indexOf("*/", position + opening)
        isInComment = close < 0
        take(CodeTokenKind.COMMENT, if (close < 0) line.length else close + "*/".length)
    }

    private inline fun endOf(belongs: (Char) -> Boolean): Int {
        var end = position + 1
        while (end < line.length && belongs(line[end])) end++
        return end
    }

    private fun take(kind: CodeTokenKind, end: Int) {
        if (end > position) tokens += CodeToken(kind, position, end)
        position = end
    }
}

private fun isNameStart(character: Char) = character.isLetter() || character == '_' || character == '$'

private fun isNamePart(character: Char) = character.isLetterOrDigit() || character == '_' || character == '$'

/** The reserved words of Java for a [brick]: leJOS NXJ has enumerations and assertions. */
internal fun keywordsFor(brick: BrickKind): Set<String> = when (brick.java) {
    JavaPlatform.LEJOS, null -> KEYWORDS
    JavaPlatform.NXJ -> NXJ_KEYWORDS
}

private val KEYWORDS = JAVA_KEYWORDS.toSet()

private val NXJ_KEYWORDS = KEYWORDS + "enum" + "assert"
