package robotran.nqc.syntax

import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.diagnostic.SourceRange

/** Splits the [text] of a [file] into tokens, one after the other. Never throws. */
internal class Lexer(private val file: String, private val text: String, private val sink: DiagnosticSink) {
    private var index = if (text.startsWith('\uFEFF')) 1 else 0
    private var line = 1
    private var lineStart = index
    private var isInDirective = false

    /** The next token; at the end of the file always one of kind [TokenKind.END]. */
    fun next(): Token {
        val isSeparate = skipToToken()
        val start = index
        if (isInDirective && (index == text.length || isLineEnd(text[index]))) {
            isInDirective = false
            return token(TokenKind.END_OF_DIRECTIVE, start, isSeparate)
        }
        if (index == text.length) return token(TokenKind.END, start, isSeparate)
        val character = text[index]
        return when {
            isNameStart(character) -> word(isSeparate)
            isDigit(character) -> number(isSeparate)
            character == '#' && !isInDirective -> directive()
            character == '"' -> quotedText(isSeparate)
            else -> sign(isSeparate)
        }
    }

    /** Skips blanks, comments and the ends of lines outside of directives; tells whether there were any. */
    private fun skipToToken(): Boolean {
        val start = index
        while (index < text.length) {
            val character = text[index]
            when {
                isBlank(character) -> index++
                isLineEnd(character) -> if (isInDirective) break else skipLineEnd()
                text.startsWith("//", index) -> skipToLineEnd()
                text.startsWith("/*", index) -> skipComment()
                !isLineJoin() -> break
            }
        }
        return index > start
    }

    /** Skips a backslash at the end of a line. */
    private fun isLineJoin(): Boolean {
        val isJoin = text[index] == '\\' && index + 1 < text.length && isLineEnd(text[index + 1])
        if (isJoin) {
            index++
            skipLineEnd()
        }
        return isJoin
    }

    private fun skipLineEnd() {
        index += if (text.startsWith("\r\n", index)) 2 else 1
        line++
        lineStart = index
    }

    private fun skipToLineEnd() {
        while (index < text.length && !isLineEnd(text[index])) index++
    }

    private fun skipComment() {
        val opening = range(index, index + 2)
        index += 2
        while (index < text.length && !text.startsWith("*/", index)) {
            if (isLineEnd(text[index])) skipLineEnd() else index++
        }
        if (index == text.length) {
            sink.report(NqcDiagnosticCode.UNTERMINATED_COMMENT, opening, sink.messages.unterminatedComment())
        } else {
            index += 2
        }
    }

    private fun word(isSeparate: Boolean): Token {
        val start = index
        skipName()
        val isKeyword = Keyword.of(text.substring(start, index)) != null
        return token(if (isKeyword) TokenKind.KEYWORD else TokenKind.NAME, start, isSeparate)
    }

    private fun skipName() {
        while (index < text.length && isNamePart(text[index])) index++
    }

    private fun number(isSeparate: Boolean): Token {
        val start = index
        index = endOfNumber(text, start)
        val value = numberOf(text.substring(start, index))
        if (value == null) {
            sink.report(NqcDiagnosticCode.NUMBER_TOO_LARGE, range(start, index), sink.messages.numberTooLarge())
        }
        return token(TokenKind.NUMBER, start, isSeparate).copy(value = value ?: 0)
    }

    private fun directive(): Token {
        val start = index++
        while (index < text.length && isBlank(text[index])) index++
        val wordStart = index
        skipName()
        isInDirective = true
        return Token(TokenKind.DIRECTIVE, text.substring(wordStart, index), range(start, index))
    }

    private fun quotedText(isSeparate: Boolean): Token {
        val start = index++
        while (index < text.length && text[index] != '"' && !isLineEnd(text[index])) index++
        val content = text.substring(start + 1, index)
        if (index < text.length && text[index] == '"') index++
        return token(TokenKind.TEXT, start, isSeparate).copy(text = content)
    }

    private fun sign(isSeparate: Boolean): Token {
        val start = index
        val length = Signs.lengthAt(text, index)
        if (length > 0) {
            index += length
            return token(TokenKind.SIGN, start, isSeparate)
        }
        index += if (text[index].isHighSurrogate() && index + 1 < text.length) 2 else 1
        return token(TokenKind.UNKNOWN, start, isSeparate)
    }

    private fun token(kind: TokenKind, start: Int, isSeparate: Boolean) =
        Token(kind, text.substring(start, index), range(start, index), isSeparate = isSeparate)

    private fun range(start: Int, end: Int) = SourceRange(file, line, start - lineStart + 1, end - lineStart + 1)
}
