package robotran.textediting.find

import robotran.language.source.SourceSpan
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import robotran.textediting.text.isWordCharacter

/**
 * A search in a text.
 *
 * @property text the text to find; an empty text has no matches.
 * @property matchCase whether upper and lower case differ.
 * @property wholeWords whether a match must not be part of a longer word.
 */
data class Search(val text: String, val matchCase: Boolean = false, val wholeWords: Boolean = false) {
    /** The matches in [source], in order and without overlaps, at most [MAX_MATCHES]. */
    fun matchesIn(source: String): List<SourceSpan> {
        if (text.isEmpty()) return emptyList()
        val found = mutableListOf<SourceSpan>()
        var position = source.indexOf(text, 0, ignoreCase = !matchCase)
        while (position >= 0 && found.size < MAX_MATCHES) {
            val span = SourceSpan(position, position + text.length)
            val counts = !wholeWords || isWhole(source, span)
            if (counts) found += span
            position = source.indexOf(text, if (counts) span.end else position + 1, ignoreCase = !matchCase)
        }
        return found
    }

    private fun isWhole(source: String, span: SourceSpan): Boolean {
        val before = source.getOrNull(span.start - 1)
        val behind = source.getOrNull(span.end)
        return (before == null || !isWordCharacter(before)) && (behind == null || !isWordCharacter(behind))
    }

    companion object {
        const val MAX_MATCHES = 5_000
    }
}

/**
 * The index in [matches] of the next match after the selection, or 0 if there is none after it; -1 if [matches] is
 * empty.
 */
fun TextDocument.nextMatch(matches: List<SourceSpan>): Int {
    if (matches.isEmpty()) return -1
    val isAtMatch = matches.any { it.start == selection.start && it.end == selection.end }
    val from = if (isAtMatch) selection.end else selection.start
    return matches.indexOfFirst { it.start >= from }.coerceAtLeast(0)
}

/** The index in [matches] of the last match before the selection, or else the last index; -1 if it is empty. */
fun TextDocument.previousMatch(matches: List<SourceSpan>): Int {
    if (matches.isEmpty()) return -1
    val before = matches.indexOfLast { it.end <= selection.start }
    return if (before >= 0) before else matches.lastIndex
}

fun TextDocument.withSelected(match: SourceSpan): TextDocument =
    copy(selection = TextSelection(match.start, match.end).within(text.length))

/** This text with each of [matches], which are in order, replaced by [replacement]. */
fun TextDocument.withAllReplaced(matches: List<SourceSpan>, replacement: String): TextDocument {
    val result = StringBuilder()
    var done = 0
    for (match in matches) {
        result.append(text, done, match.start).append(replacement)
        done = match.end
    }
    result.append(text, done, text.length)
    val before = matches.count { it.end <= selection.caret }
    val caret = selection.caret + before * replacement.length - matches.take(before).sumOf { it.length }
    return TextDocument(result.toString()).withCaret(caret)
}
