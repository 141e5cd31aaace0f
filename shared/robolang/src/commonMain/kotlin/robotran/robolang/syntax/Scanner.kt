package robotran.robolang.syntax

import robotran.robolang.Mistakes
import robotran.robolang.SourceRange

private const val BYTE_ORDER_MARK = "\uFEFF"
private const val QUOTATION_MARK = '"'

/** Takes [source] apart into lines and these into tokens; what is no token is reported, once a line. */
internal fun scan(source: String, mistakes: Mistakes): List<ScannedLine> =
    source.removePrefix(BYTE_ORDER_MARK).lineSequence()
        .mapIndexed { index, text -> LineScanner(text, index + 1, mistakes).scan() }
        .toList()

/** Takes one line apart. */
private class LineScanner(
    private val text: String,
    private val number: Int,
    private val mistakes: Mistakes,
) {
    private val tokens = mutableListOf<Token>()
    private var comment: Token? = null
    private var position = 0

    fun scan(): ScannedLine {
        while (position < text.length) {
            piece()
        }
        return ScannedLine(number, text, tokens, comment)
    }

    private fun piece() {
        val character = text[position]
        when {
            isBlank(character) -> position++
            isLetter(character) -> takeWhile(TokenKind.WORD) { isLetter(it) || isDigit(it) }
            beginsNumber() -> takeWhile(TokenKind.NUMBER) { isDigit(it) || it == '.' }
            text.startsWith("//", position) -> takeComment()
            character == QUOTATION_MARK -> takeText()
            else -> sign()
        }
    }

    private fun sign() {
        val sign = TokenKind.SIGNS.firstOrNull { text.startsWith(checkNotNull(it.text), position) }
        val slipWidth = widthOfSlip(text, position)
        when {
            slipWidth > 0 -> unknownCharacter(slipWidth)
            sign != null -> take(sign, checkNotNull(sign.text).length)
            else -> unknownCharacter(characterWidth(text, position))
        }
    }

    private fun takeText() {
        val closing = text.indexOf(QUOTATION_MARK, position + 1)
        if (closing >= 0) {
            take(TokenKind.TEXT, closing + 1 - position)
        } else {
            val end = text.trimEnd { isBlank(it) }.length
            mistakes.reportUnclosedText(text, SourceRange(number, position + 1, end + 1))
            take(TokenKind.TEXT, end - position)
        }
    }

    private fun beginsNumber(): Boolean =
        isDigit(text[position]) || (text[position] == '.' && text.getOrNull(position + 1)?.let(::isDigit) == true)

    private inline fun takeWhile(kind: TokenKind, belongs: (Char) -> Boolean) {
        var end = position
        while (end < text.length && belongs(text[end])) {
            end++
        }
        take(kind, end - position)
    }

    private fun take(kind: TokenKind, length: Int) {
        tokens += token(kind, length)
    }

    private fun takeComment() {
        comment = token(TokenKind.COMMENT, text.trimEnd { isBlank(it) }.length - position)
        position = text.length
    }

    private fun token(kind: TokenKind, length: Int): Token {
        val start = position
        position += length
        val typed = text.substring(start, position)
        val keyword = if (kind == TokenKind.WORD) Keyword.of(typed) else null
        return Token(kind, SourceRange(number, start + 1, position + 1), typed, keyword)
    }

    private fun unknownCharacter(width: Int) {
        mistakes.reportCharacter(text, SourceRange(number, position + 1, position + 1 + width))
        position += width
    }
}

/** Two for a pair of surrogates, which is one character to whoever typed it. */
private fun characterWidth(text: String, position: Int): Int =
    if (text[position].isHighSurrogate() && position + 1 < text.length && text[position + 1].isLowSurrogate()) 2 else 1
