package robotran.projects

/**
 * A link in a text.
 *
 * @property line in which it begins, from 1; in a part that a mail has encoded, the line of that part.
 * @property link the part that matters, `#p=a...`.
 */
data class FoundLink(val line: Int, val link: String)

/**
 * All links in [text], in their order, as mails and chats bring them: among other words, in quoted-printable or Base64,
 * wrapped into lines, and rewritten by a mail filter. A link that was wrapped ends where it is whole.
 */
suspend fun linksIn(text: String): List<FoundLink> =
    writtenLinksIn(text).take(ProjectLimits.MAXIMUM_LINKS).toList().map { written ->
        // Nothing but its content tells whether the next line belongs to a link.
        val whole = if (written.readings.size == 1) null else written.readings.firstOrNull { isWholeLink(it) }
        FoundLink(written.line, whole ?: written.readings.last())
    }

/** Whether [text] is or has a Robotran link, or a part of one, rather than a file name. */
fun isLink(text: String): Boolean = writtenLinksIn(text).any()

/**
 * A link as it is written in a text.
 *
 * @property readings what it may be, the longest first; the last has no more than its first line.
 */
internal class WrittenLink(val line: Int, val readings: List<String>)

/** The links in [text] and in the parts of it that are in Base64. */
internal fun writtenLinksIn(text: String): Sequence<WrittenLink> = sequence {
    yieldAll(LinkScanner(MailText.of(text)).links())
    for (part in base64PartsIn(text)) {
        yieldAll(LinkScanner(MailText.of(part.text)).links().map { WrittenLink(part.line, it.readings) })
    }
}

/** Finds the links in a text. */
private class LinkScanner(private val mail: MailText) {
    private val text = mail.text

    fun links(): Sequence<WrittenLink> = sequence {
        val lines = mail.lines()
        for (start in LINK_START.findAll(text)) {
            val style = LinkStyle.entries.first { start.groups[it.ordinal + 1] != null }
            val first = start.range.first
            lines.goTo(first)
            if (style.isOfFilter && FILTER !in text.substring(maxOf(0, first - FILTER_BEFORE), first)) continue
            val kind = start.value.first { it in KINDS }
            val pieces = piecesFrom(start.range.last + 1, lines.start, style)
            if (pieces.first().isEmpty()) continue
            val counts = listOf(pieces.size, pieces.size - 1, 1).filter { it > 0 }.distinct()
            yield(WrittenLink(lines.line, counts.map { "#$kind=" + pieces.take(it).joinToString("") }))
        }
    }

    /** The data from [from] on, and what of the next lines may go on with them. */
    private fun piecesFrom(from: Int, lineStart: Int, style: LinkStyle): List<String> {
        val pieces = mutableListOf<String>()
        var start = from
        var begin = lineStart
        var width: Int? = null
        var length = 0
        while (length <= ProjectLimits.MAXIMUM_LINK_CHARACTERS) {
            val end = style.endOfData(text, start)
            val piece = style.decoded(text.substring(start, end))
            pieces += piece
            length += piece.length
            val lineEnd = BLANKS_AND_BREAK.matchAt(text, end) ?: break
            val columns = end - begin
            // All lines of a wrapped link but the last are of one length, except that the first may begin earlier.
            val isFull = columns >= NARROWEST && (width == null || columns == width)
            if (!isFull) break
            if (pieces.size > 1) width = columns
            begin = lineEnd.range.last + 1
            start = begin + checkNotNull(QUOTING.matchAt(text, begin)).value.length
            if (style.endOfData(text, start) == start) break
        }
        return pieces
    }
}

/** Which characters of an address are written in another way. */
private enum class LinkStyle(val start: String, private val escapes: Regex? = null) {
    PLAIN("#K=(?:3D)?"),

    /** Percent-encoded, once or several times, in the address of a mail filter or search engine. */
    PERCENT("%(?:25)*23K%(?:25)*3[Dd]", Regex("%(?:25)*(2D|5F)", RegexOption.IGNORE_CASE)),

    /** By a filter that uses `-` for `%`. */
    DASHED("-23K-3[Dd]", Regex("-(2D|5F)", RegexOption.IGNORE_CASE)),

    /** By a filter that uses `*` for the `#`. */
    STARRED("\\*K=(?:3D)?"),
    ;

    /** Whether its signs mean what they do only in the address of such a filter. */
    val isOfFilter: Boolean get() = this == DASHED || this == STARRED

    /** Where the data end that begin at [from] in [text]. */
    fun endOfData(text: String, from: Int): Int {
        var place = from
        while (place < text.length) {
            val escape = if (text[place] == '%' || text[place] == '-') escapes?.matchAt(text, place) else null
            place += when {
                escape != null -> escape.value.length
                this == DASHED && text[place] in "-_" -> break
                this == STARRED && text.startsWith(STARRED_END, place) -> break
                isLinkCharacter(text[place]) -> 1
                else -> break
            }
        }
        return place
    }

    fun decoded(written: String): String = escapes?.replace(written) {
        if (it.groupValues[1].equals("2D", ignoreCase = true)) "-" else "_"
    } ?: written

    private companion object {
        const val STARRED_END = "__;"
    }
}

private fun isLinkCharacter(character: Char): Boolean =
    character in 'a'..'z' || character in 'A'..'Z' || character in '0'..'9' || character == '-' || character == '_'

private const val KINDS = "wpch"
private const val FILTER = "urldefense"

/** An address before a link is no longer, within the lines of a mail. */
private const val FILTER_BEFORE = 700

/** What is written together in a regular expression for the start of a link. */
private val START_PART = Regex("\\(\\?:[^)]*\\)[*?]|\\[[^\\]]*\\]|\\\\.|.")

/** One group for each style. A link may be wrapped anywhere, also in its first characters. */
private val LINK_START = Regex(
    LinkStyle.entries.joinToString("|") { style ->
        val parts = START_PART.findAll(style.start).map { it.value.replace("K", "[$KINDS]") }
        "(${parts.joinToString(BREAK)})"
    },
)
private const val BREAK = "(?:\\r?\\n[> ]{0,9})?"
private val BLANKS_AND_BREAK = Regex("[ \\t]{0,9}\\r?\\n")
private val QUOTING = Regex("[> ]{0,9}")

/** No mail program wraps lines that are shorter. */
private const val NARROWEST = 40
