package robotran.nqc.edit

import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.api.NqcApi
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.Signs
import robotran.nqc.syntax.endOfNumber
import robotran.nqc.syntax.isDigit
import robotran.nqc.syntax.isNamePart
import robotran.nqc.syntax.isNameStart

/**
 * A word, number or sign of a line, for syntax highlighting.
 *
 * @property start its first column, from 0.
 * @property end the column after its last character.
 */
data class NqcToken(val kind: NqcTokenKind, val start: Int, val end: Int)

enum class NqcTokenKind {
    KEYWORD,

    /** A name of the API. */
    BUILT_IN,
    NAME,
    NUMBER,
    TEXT,
    SIGN,
    COMMENT,

    /** `#` and the word after it. */
    DIRECTIVE,
}

/**
 * The tokens of a line. Blanks and unknown characters are in none.
 *
 * @property endsInComment whether the next line begins inside a comment.
 */
data class NqcLineTokens(val tokens: List<NqcToken>, val endsInComment: Boolean)

/** Splits one [line] of NQC into tokens. Never throws for any input. */
fun nqcTokens(line: String, startsInComment: Boolean): NqcLineTokens = LineScanner(line, startsInComment).scan()

private class LineScanner(private val line: String, private var isInComment: Boolean) {
    private val tokens = mutableListOf<NqcToken>()
    private var position = 0

    fun scan(): NqcLineTokens {
        if (isInComment) takeComment(0)
        while (position < line.length) takeToken()
        return NqcLineTokens(tokens, isInComment)
    }

    private fun takeToken() {
        val character = line[position]
        val signLength = Signs.lengthAt(line, position)
        when {
            line.startsWith("//", position) -> take(NqcTokenKind.COMMENT, line.length)
            line.startsWith("/*", position) -> takeComment(2)
            character == '#' && tokens.none { it.kind != NqcTokenKind.COMMENT } -> takeDirective()
            isNameStart(character) -> takeWord()
            isDigit(character) -> take(NqcTokenKind.NUMBER, endOfNumber(line, position))
            character == '"' -> takeText()
            signLength > 0 -> take(NqcTokenKind.SIGN, position + signLength)
            else -> position++
        }
    }

    private fun takeComment(openingLength: Int) {
        val closing = line.indexOf("*/", minOf(line.length, position + openingLength))
        isInComment = closing < 0
        take(NqcTokenKind.COMMENT, if (closing < 0) line.length else closing + 2)
    }

    private fun takeDirective() {
        var end = position + 1
        while (end < line.length && (line[end] == ' ' || line[end] == '\t')) end++
        while (end < line.length && isNamePart(line[end])) end++
        take(NqcTokenKind.DIRECTIVE, end)
    }

    private fun takeWord() {
        var end = position
        while (end < line.length && isNamePart(line[end])) end++
        val word = line.substring(position, end)
        val kind = when {
            Keyword.of(word) != null -> NqcTokenKind.KEYWORD
            word in API_NAMES -> NqcTokenKind.BUILT_IN
            else -> NqcTokenKind.NAME
        }
        take(kind, end)
    }

    private fun takeText() {
        val closing = line.indexOf('"', position + 1)
        take(NqcTokenKind.TEXT, if (closing < 0) line.length else closing + 1)
    }

    private fun take(kind: NqcTokenKind, end: Int) {
        if (end > position) tokens += NqcToken(kind, position, end)
        position = end
    }

    private companion object {
        val API_NAMES: Set<String> by lazy {
            FirmwareTarget.entries.flatMap { target ->
                NqcApi.of(target).keys + NqcApi.of(target, isOld = true).keys
            }.toSet()
        }
    }
}
