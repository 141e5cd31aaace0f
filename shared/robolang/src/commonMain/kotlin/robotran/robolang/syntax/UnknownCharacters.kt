package robotran.robolang.syntax

import robotran.language.pasted.PastedCharacter
import robotran.language.pasted.pastedCharacter
import robotran.language.pasted.plainTextOf
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.Keyword
import robotran.robolang.words.isBlank
import robotran.robolang.words.isInvisible
import robotran.robolang.words.isLetter
import robotran.robolang.words.unicodeNumber

/** Characters of other languages, with their spelling in Robolang. */
private val RIGHT_SPELLINGS: Map<String, String> = mapOf(
    "&&" to "and",
    "||" to "or",
    "<>" to "!=",
    "=<" to "<=",
    "=>" to ">=",
    ":=" to "=",
    "&" to "and",
    "|" to "or",
    "!" to "not",
    "%" to "mod",
    "\u00B0" to "degrees",
)

private val LONG_SLIPS: List<String> = RIGHT_SPELLINGS.keys.filter { it.length > 1 }

/**
 * The length of pasted characters, or of another language's operator, at [position] of [text] that begins like one of
 * Robolang; 0 if there are none.
 */
internal fun widthOfSlip(text: String, position: Int): Int {
    var pasted = 0
    while (position + pasted < text.length && isVisiblyPasted(text[position + pasted])) pasted++
    return if (pasted > 0) pasted else LONG_SLIPS.firstOrNull { text.startsWith(it, position) }?.length ?: 0
}

private fun isVisiblyPasted(character: Char): Boolean =
    pastedCharacter(character)?.isUnseen == false && !isQuotationMark(character)

/** Reports the invalid character at [range] of the line [text]. */
internal fun DiagnosticSink.reportCharacter(text: String, range: SourceRange) {
    if (range.line in lines) return
    val written = text.substring(range.column - 1, range.endColumn - 1)
    pastedCharacter(written[0])?.let { return reportPasted(it, text, range, written) }
    val right = RIGHT_SPELLINGS[written]
    val (message, replacement) = when {
        right != null -> messages.characterInsteadOf(written, right) to spaced(right, text, range)
        written == ";" -> messages.semicolon() to ""
        written == ":" && isLast(text, range.column - 1) -> messages.colon() to ""
        isOtherEnd(text, range.column - 1) -> messages.characterInsteadOf(written, Keyword.END.text) to Keyword.END.text
        written == "{" || written == "}" -> messages.brace(written) to ""
        written == "#" -> messages.commentBegins() to "//"
        written.length == 1 && isInvisible(written[0]) -> messages.invisibleCharacter(unicodeNumber(written[0])) to ""
        else -> messages.unknownCharacter(written) to null
    }
    report(DiagnosticCode.UNKNOWN_CHARACTER, range, written, message, replacement?.let { SourceFix(range, it) })
}

/** Reports [pasted] at [range], with a fix for all pasted characters of the line that are in no text or comment. */
private fun DiagnosticSink.reportPasted(pasted: PastedCharacter, text: String, range: SourceRange, written: String) {
    val end = text.indexOf("//", range.endColumn - 1).let { if (it < 0) text.length else it }
    val start = range.endColumn - 1
    val code = text.substring(start, end).takeWhile { !isQuotationMark(it) }
    val rest = code.indexOfLast { pastedCharacter(it) != null && !isBlank(it) } + 1
    val place = range.copy(endColumn = range.endColumn + rest)
    val fix = SourceFix(place, plainTextOf(written + code.take(rest)))
    report(DiagnosticCode.UNKNOWN_CHARACTER, range, written, messages.pastedCharacter(pasted, written), fix)
}

/** Whether a brace at [position] is alone on its line, as at the end of a block in other languages. */
internal fun isOtherEnd(text: String, position: Int): Boolean =
    text[position] == '}' && text.indexOfFirst { !isBlank(it) } == position && isLast(text, position)

/** Whether only a comment follows the character at [position]. */
private fun isLast(text: String, position: Int): Boolean {
    var next = position + 1
    while (next < text.length && isBlank(text[next])) next++
    return next == text.length || text.startsWith("//", next)
}

/** Whether a space is needed: between words, but not next to signs. */
private fun spaced(right: String, text: String, range: SourceRange): String {
    if (!isLetter(right[0])) return right
    val before = text.getOrNull(range.column - 2)?.let { if (isBlank(it)) "" else " " }.orEmpty()
    val behind = text.getOrNull(range.endColumn - 1)?.let { if (isBlank(it)) "" else " " }.orEmpty()
    return before + right + behind
}

/** Reports a text with other quotation marks, the first and last character at [range]. */
internal fun DiagnosticSink.reportOtherMarks(text: String, range: SourceRange) {
    val written = text.substring(range.column - 1, range.endColumn - 1)
    val wrong = if (written.first() == '"') written.last() else written.first()
    val fix = SourceFix(range, "\"" + written.substring(1, written.length - 1) + "\"")
    report(DiagnosticCode.UNKNOWN_CHARACTER, range, written, messages.characterInsteadOf(wrong.toString(), "\""), fix)
}

/** Reports a text without its closing quotation mark. */
internal fun DiagnosticSink.reportUnclosedText(text: String, range: SourceRange) {
    val end = SourceRange(range.line, range.endColumn, range.endColumn)
    val written = text.substring(range.column - 1, range.endColumn - 1)
    report(DiagnosticCode.UNCLOSED_TEXT, range, written, messages.unclosedText(), SourceFix(end, "\""))
}
