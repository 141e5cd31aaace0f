package robotran.projects

import robotran.language.decodeText
import kotlin.io.encoding.Base64

/**
 * A text that may be a mail, without the line ends that quoted-printable has added.
 *
 * @property removed where they were in [text].
 */
internal class MailText private constructor(val text: String, private val removed: List<Int>) {
    fun lines() = Lines()

    /** Counts the lines of the original text from place to place, so that a long text is counted once. */
    inner class Lines {
        private var place = 0
        private var removedBefore = 0
        private var breaks = 0

        /** From 1. */
        val line: Int get() = 1 + breaks + removedBefore

        /** Where the line begins in [text]. */
        var start = 0
            private set

        /** Goes forward to [next]. */
        fun goTo(next: Int) {
            while (place < next) {
                if (text[place++] == '\n') {
                    breaks++
                    start = place
                }
            }
            while (removedBefore < removed.size && removed[removedBefore] <= next) removedBefore++
        }
    }

    companion object {
        fun of(text: String): MailText {
            if (!isQuotedPrintable(text)) return MailText(text, emptyList())
            val removed = mutableListOf<Int>()
            val joined = StringBuilder(text.length)
            var from = 0
            for (lineEnd in SOFT_LINE_END.findAll(text)) {
                joined.append(text, from, lineEnd.range.first)
                removed += joined.length
                from = lineEnd.range.last + 1
            }
            joined.append(text, from, text.length)
            return MailText(ESCAPED_HASH.replace("$joined", "#"), removed)
        }

        private fun isQuotedPrintable(text: String): Boolean =
            "=3D" in text || text.contains("quoted-printable", ignoreCase = true)

        private val SOFT_LINE_END = Regex("=[ \\t]{0,9}\\r?\\n")
        private val ESCAPED_HASH = Regex("=23(?=[wpch]=3D)")
    }
}

/** @property line in which the part begins, from 1. */
internal class MailPart(val line: Int, val text: String)

/** The texts in [mail] that are in Base64. */
internal fun base64PartsIn(mail: String): Sequence<MailPart> = BASE64_HEAD.findAll(mail).mapNotNull { head ->
    val begin = head.range.last + 1
    var end = begin
    while (end < mail.length && isInBase64(mail, end)) end++
    val text = try {
        decodeText(Base64.decode(mail.substring(begin, end).filterNot { it in LINE_END }))?.text
    } catch (_: IllegalArgumentException) {
        null
    }
    text?.let { MailPart(1 + mail.substring(0, begin).count { it == '\n' }, it) }
}

/** An empty line ends the part. */
private fun isInBase64(mail: String, offset: Int): Boolean = when (val character = mail[offset]) {
    '\n' -> mail.getOrNull(offset + 1)?.let { it !in LINE_END } == true
    '\r', '+', '/', '=' -> true
    else -> character in 'A'..'Z' || character in 'a'..'z' || character in '0'..'9'
}

private const val LINE_END = "\r\n"

/** The header with the encoding, and what else the head of the part has. */
private val BASE64_HEAD = Regex(
    "^Content-Transfer-Encoding:[ \\t]*base64[ \\t]*\\r?\\n(?:[^\\r\\n]+\\r?\\n){0,50}\\r?\\n",
    setOf(RegexOption.IGNORE_CASE, RegexOption.MULTILINE),
)
