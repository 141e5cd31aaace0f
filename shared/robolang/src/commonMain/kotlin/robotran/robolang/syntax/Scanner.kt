package robotran.robolang.syntax

import robotran.robolang.Mistakes
import robotran.robolang.SourceRange

private const val BYTE_ORDER_MARK = "\uFEFF"

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
    private var mistaken = false
    private var position = 0

    fun scan(): ScannedLine {
        while (position < text.length) {
            piece()
        }
        return ScannedLine(number, text, tokens, comment, mistaken)
    }

    private fun piece() {
        val start = position
        val character = text[start]
        when {
            isBlank(character) -> position++
            isLetter(character) -> {
                skipWhile { isLetter(it) || isDigit(it) }
                add(TokenKind.WORD, start)
            }
            beginsNumber() -> {
                skipWhile { isDigit(it) || it == '.' }
                add(TokenKind.NUMBER, start)
            }
            text.startsWith("//", start) -> {
                position = text.length
                comment = token(TokenKind.COMMENT, start)
            }
            character == '-' -> {
                position++
                add(TokenKind.MINUS, start)
            }
            character == ',' -> {
                position++
                add(TokenKind.COMMA, start)
            }
            else -> unknownCharacter()
        }
    }

    private fun beginsNumber(): Boolean =
        isDigit(text[position]) || text[position] == '.' && position + 1 < text.length && isDigit(text[position + 1])

    private inline fun skipWhile(belongs: (Char) -> Boolean) {
        while (position < text.length && belongs(text[position])) {
            position++
        }
    }

    private fun unknownCharacter() {
        if (!mistaken) {
            mistaken = true
            mistakes.reportCharacter(text, SourceRange(number, position + 1, position + 1 + characterWidth(text, position)))
        }
        position += characterWidth(text, position)
    }

    private fun add(kind: TokenKind, start: Int) {
        tokens += token(kind, start)
    }

    private fun token(kind: TokenKind, start: Int): Token {
        val typed = text.substring(start, position)
        val keyword = if (kind == TokenKind.WORD) Keyword.of(typed) else null
        return Token(kind, SourceRange(number, start + 1, position + 1), typed, keyword)
    }
}

/** Two for a pair of surrogates, which is one character to whoever typed it. */
private fun characterWidth(text: String, position: Int): Int =
    if (text[position].isHighSurrogate() && position + 1 < text.length && text[position + 1].isLowSurrogate()) 2 else 1
