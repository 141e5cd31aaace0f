package robotran.robolang.syntax

import robotran.language.pasted.pastedCharacter
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.Keyword
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.isBlank
import robotran.robolang.words.isDigit
import robotran.robolang.words.isLetter
import robotran.robolang.words.vocabularyOf

internal const val BYTE_ORDER_MARK = "\uFEFF"
private const val QUOTATION_MARK = '"'

/** Whether [character] is the quotation mark of Robolang, or one of word processors and other languages. */
internal fun isQuotationMark(character: Char): Boolean =
    character in KEYBOARD_MARKS || pastedCharacter(character)?.plain.let { it == "\"" || it == "'" }

private const val KEYBOARD_MARKS = "\"'`"

/**
 * Splits [source] into lines and tokens. Reports invalid characters, once per line.
 *
 * @param vocabulary the words that it is written in, which the [diagnostics] are told in, too.
 */
internal fun scan(
    source: String,
    diagnostics: DiagnosticSink,
    vocabulary: Vocabulary = vocabularyOf(source),
): List<ScannedLine> {
    diagnostics.vocabulary = vocabulary
    return withDeclaredNames(
        source.removePrefix(BYTE_ORDER_MARK).lineSequence()
            .mapIndexed { index, text -> LineScanner(text, index + 1, diagnostics).scan() }
            .toList(),
    )
}

/** Splits one line into tokens. */
private class LineScanner(private val text: String, private val number: Int, private val diagnostics: DiagnosticSink) {
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
            isQuotationMark(character) && closingMark() > 0 -> takeText(closingMark())
            character == QUOTATION_MARK -> takeUnclosedText()
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

    /** The end of the text that begins here: the same quotation mark, otherwise another one; -1 if there is none. */
    private fun closingMark(): Int {
        if (text[position] == QUOTATION_MARK) text.indexOf(QUOTATION_MARK, position + 1).let { if (it >= 0) return it }
        return (position + 1..text.lastIndex).firstOrNull { isQuotationMark(text[it]) } ?: -1
    }

    private fun takeText(closing: Int) {
        val range = SourceRange(number, position + 1, closing + 2)
        if (text[position] != QUOTATION_MARK || text[closing] != QUOTATION_MARK) {
            diagnostics.reportOtherMarks(text, range)
        }
        take(TokenKind.TEXT, closing + 1 - position)
    }

    private fun takeUnclosedText() {
        val end = text.trimEnd { isBlank(it) }.length
        diagnostics.reportUnclosedText(text, SourceRange(number, position + 1, end + 1))
        take(TokenKind.TEXT, end - position)
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
        val first = tokens.firstOrNull()?.keyword
        val keyword = if (kind == TokenKind.WORD) diagnostics.vocabulary.keyword(typed, first) else null
        return Token(kind, SourceRange(number, start + 1, position + 1), typed, keyword)
    }

    private fun unknownCharacter(width: Int) {
        diagnostics.reportCharacter(text, SourceRange(number, position + 1, position + 1 + width))
        if (isOtherEnd(text, position)) {
            tokens +=
                Token(TokenKind.WORD, SourceRange(number, position + 1, position + 2), "}", Keyword.END)
        }
        position += width
    }
}

/** Two for a surrogate pair, which is one character to the pupil. */
private fun characterWidth(text: String, position: Int): Int =
    if (text[position].isHighSurrogate() && position + 1 < text.length && text[position + 1].isLowSurrogate()) 2 else 1
