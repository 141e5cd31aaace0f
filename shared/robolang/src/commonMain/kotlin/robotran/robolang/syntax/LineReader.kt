package robotran.robolang.syntax

import robotran.language.source.SourceRange
import robotran.robolang.words.Keyword

/**
 * Reads the tokens of one line, which has at least one.
 *
 * @param nextLine the next line that has any, which may tell what a mistake should have been.
 */
internal class LineReader(val line: ScannedLine, val nextLine: ScannedLine? = null) {
    private val tokens = line.tokens
    private var position = 0

    /** The names read so far. */
    val names = mutableListOf<Name>()

    /** The first token, whose column is the line's indentation. */
    val first: Token get() = tokens.first()

    /** The next token; null at the end of the line. */
    val next: Token? get() = tokens.getOrNull(position)

    /** The zero-width range after the last token read, for missing text. */
    val gap: SourceRange
        get() {
            val column = if (position == 0) first.range.column else tokens[position - 1].range.endColumn
            return SourceRange(line.number, column, column)
        }

    /** From the token [from] to the last one read. */
    fun rangeFrom(from: SourceRange): SourceRange = from.copy(endColumn = gap.endColumn)

    /** From the first token to the last one read. */
    val readRange: SourceRange get() = SourceRange(line.number, first.range.column, gap.endColumn)

    /** From the next token to the last one of the line. */
    val restRange: SourceRange
        get() = SourceRange(line.number, next?.range?.column ?: gap.column, tokens.last().range.endColumn)

    fun advance() {
        position++
    }

    /** Reads the next token if it is one of the [keywords]. */
    fun take(vararg keywords: Keyword): Keyword? {
        val keyword = next?.keyword
        if (keyword == null || keyword !in keywords) return null
        advance()
        return keyword
    }

    /** Reads the next token if it is of [kind]. */
    fun take(kind: TokenKind): Token? = next?.takeIf { it.kind == kind }?.also { advance() }

    /** Reads the next token as a name. */
    fun takeName(): Name? {
        val token = next?.takeIf { it.canBeName } ?: return null
        advance()
        return Name(token.range, token.text).also { names += it }
    }

    /** The token [distance] after the next one. */
    fun peek(distance: Int): Token? = tokens.getOrNull(position + distance)

    fun textOf(range: SourceRange): String = line.text.substring(range.column - 1, range.endColumn - 1)

    /** The text at [range], shortened for a message. */
    fun quotable(range: SourceRange): String = shortened(textOf(range))
}

/** [text], shortened if it is long. */
internal fun shortened(text: String): String =
    if (text.length <= RobolangLimits.QUOTED_CHARACTERS) text else text.take(RobolangLimits.QUOTED_CHARACTERS) + "..."
