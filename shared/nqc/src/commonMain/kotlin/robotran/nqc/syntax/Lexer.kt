package robotran.nqc.syntax

import robotran.language.pasted.plainTextOf
import robotran.language.source.SourceRange
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode

/**
 * Splits the [text] of a [file] into tokens, one after the other. Pasted characters are read as those of a keyboard.
 * Never throws.
 *
 * @param isActive whether what is read now belongs to the program: what a condition leaves out may be anything.
 */
internal class Lexer(
    private val file: String,
    private val text: String,
    private val sink: DiagnosticSink,
    private val isActive: () -> Boolean = { true },
) {
    private val pasted = PastedText(text, sink)
    private var index = if (text.startsWith('\uFEFF')) 1 else 0
    private var line = 1
    private var lineStart = index
    private var isInDirective = false

    /** Whether the line is a text for people, as after `#error`. */
    private var isProse = false

    /** The next token; at the end of the file always one of kind [TokenKind.END]. */
    fun next(): Token {
        val isSeparate = skipToToken()
        val start = index
        if (isInDirective && (index == text.length || isLineEnd(text[index]))) {
            isInDirective = false
            isProse = false
            return token(TokenKind.END_OF_DIRECTIVE, start, isSeparate)
        }
        if (index == text.length) return token(TokenKind.END, start, isSeparate)
        val character = text[index]
        return when {
            isNameStart(character) || pasted.isNameStart(index) -> word(isSeparate)
            isDigit(character) -> number(isSeparate)
            character == '#' && !isInDirective -> directive()
            pasted.endOfQuote(index) > 0 -> quotedText(isSeparate)
            pasted.isVisible(index) -> pastedToken(isSeparate)
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
                pasted.isUnseen(index) -> skipUnseen()
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

    /** Skips blanks that look like ordinary ones, and what cannot be seen. */
    private fun skipUnseen() {
        val start = index
        while (pasted.isUnseen(index)) index++
        report(start)
    }

    /** Reports the pasted characters from [start] to here. */
    private fun report(start: Int) {
        if (isActive() && !isProse) pasted.report(start, index, range(start, index))
    }

    private fun word(isSeparate: Boolean): Token {
        val start = index
        skipName()
        val typed = text.substring(start, index)
        val isPlain = typed.all { isNamePart(it) }
        val name = if (isPlain) typed else plainTextOf(typed)
        if (!isPlain) report(start)
        val isKeyword = Keyword.of(name) != null
        return token(if (isKeyword) TokenKind.KEYWORD else TokenKind.NAME, start, isSeparate).copy(text = name)
    }

    /** A number or a sign that begins with a pasted character, as the keyboard writes it. */
    private fun pastedToken(isSeparate: Boolean): Token {
        val start = index
        if (pasted.isQuote(start)) {
            index++
            return token(TokenKind.UNKNOWN, start, isSeparate)
        }
        val isNumber = isDigit(pasted.plainAt(start))
        index = if (isNumber) pasted.endOfDigits(start) else start + pasted.lengthOfSign(start)
        report(start)
        val plain = plainTextOf(text.substring(start, index))
        val kind = if (isNumber) TokenKind.NUMBER else TokenKind.SIGN
        val isKnown = isNumber || Signs.lengthAt(plain, 0) == plain.length
        val token = token(if (isKnown) kind else TokenKind.UNKNOWN, start, isSeparate).copy(text = plain)
        return if (isNumber) token.copy(value = numberOf(plain) ?: 0) else token
    }

    private fun skipName() {
        while (index < text.length && (isNamePart(text[index]) || pasted.isInName(index))) index++
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
        val word = plainTextOf(text.substring(wordStart, index))
        isProse = word in PROSE
        return Token(TokenKind.DIRECTIVE, word, range(start, index))
    }

    private fun quotedText(isSeparate: Boolean): Token {
        val start = index
        index = pasted.endOfQuote(start)
        val quote = text.substring(start, index)
        val isClosed = quote.length > 1 && pasted.isQuote(index - 1)
        // Outside of directives there are no texts, so that their marks make no difference.
        if (isInDirective && isClosed && quote != pasted.quoted(quote)) report(start)
        val content = if (isClosed) quote.substring(1, quote.length - 1) else quote.substring(1)
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

    private fun range(start: Int, end: Int) = SourceRange(line, start - lineStart + 1, end - lineStart + 1, file)

    private companion object {
        /** The directives after which a text for people comes. */
        val PROSE = setOf("error", "warning")
    }
}
