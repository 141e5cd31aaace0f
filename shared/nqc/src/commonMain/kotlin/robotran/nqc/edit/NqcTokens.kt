package robotran.nqc.edit

import robotran.languagesupport.CodeToken
import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.LineTokens
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.api.NqcApi
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.Signs
import robotran.nqc.syntax.endOfNumber
import robotran.nqc.syntax.isDigit
import robotran.nqc.syntax.isNamePart
import robotran.nqc.syntax.isNameStart

/** Splits one [line] of NQC into tokens. Never throws for any input. */
fun nqcTokens(line: String, startsInComment: Boolean): LineTokens = LineScanner(line, startsInComment).scan()

private class LineScanner(private val line: String, private var isInComment: Boolean) {
    private val tokens = mutableListOf<CodeToken>()
    private var position = 0

    fun scan(): LineTokens {
        if (isInComment) takeComment(0)
        while (position < line.length) takeToken()
        return LineTokens(tokens, isInComment)
    }

    private fun takeToken() {
        val character = line[position]
        val signLength = Signs.lengthAt(line, position)
        when {
            line.startsWith("//", position) -> take(CodeTokenKind.COMMENT, line.length)
            line.startsWith("/*", position) -> takeComment(2)
            character == '#' && tokens.none { it.kind != CodeTokenKind.COMMENT } -> takeDirective()
            isNameStart(character) -> takeWord()
            isDigit(character) -> take(CodeTokenKind.NUMBER, endOfNumber(line, position))
            character == '"' -> takeText()
            signLength > 0 -> take(CodeTokenKind.SIGN, position + signLength)
            else -> position++
        }
    }

    private fun takeComment(openingLength: Int) {
        val closing = line.indexOf("*/", minOf(line.length, position + openingLength))
        isInComment = closing < 0
        take(CodeTokenKind.COMMENT, if (closing < 0) line.length else closing + 2)
    }

    private fun takeDirective() {
        var end = position + 1
        while (end < line.length && (line[end] == ' ' || line[end] == '\t')) end++
        while (end < line.length && isNamePart(line[end])) end++
        take(CodeTokenKind.KEYWORD, end)
    }

    private fun takeWord() {
        var end = position
        while (end < line.length && isNamePart(line[end])) end++
        val word = line.substring(position, end)
        val kind = when {
            Keyword.of(word) != null -> CodeTokenKind.KEYWORD
            word in API_NAMES -> CodeTokenKind.BUILT_IN
            else -> CodeTokenKind.NAME
        }
        take(kind, end)
    }

    private fun takeText() {
        val closing = line.indexOf('"', position + 1)
        take(CodeTokenKind.TEXT, if (closing < 0) line.length else closing + 1)
    }

    private fun take(kind: CodeTokenKind, end: Int) {
        if (end > position) tokens += CodeToken(kind, position, end)
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
