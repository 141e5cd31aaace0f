package robotran.robolang.syntax

import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.diagnostic.SourceFix
import robotran.robolang.diagnostic.SourceRange

/** What keyboards, word processors and other languages put where Robolang has a spelling of its own. */
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
    "\u2212" to "-",
    "\u2010" to "-",
    "\u2011" to "-",
    "\u2013" to "-",
    "\u2014" to "-",
    "\u00D7" to "*",
    "\u00F7" to "/",
    "\u2260" to "!=",
    "\u2264" to "<=",
    "\u2265" to ">=",
    "\u00B0" to "degrees",
)

private val LONG_SLIPS: List<String> = RIGHT_SPELLINGS.keys.filter { it.length > 1 }

/** Figures, letters and signs as wide as Chinese ones stand in the order of the plain ones, this much further up. */
private const val WIDE_OFFSET = 0xFEE0
private val WIDE_CHARACTERS = '\uFF01'..'\uFF5E'

/**
 * How long the sign of another language is that stands at [position] of [text] and begins like one of Robolang; 0 if
 * none does.
 */
internal fun widthOfSlip(text: String, position: Int): Int {
    var wide = 0
    while (position + wide < text.length && text[position + wide] in WIDE_CHARACTERS) wide++
    return if (wide > 0) wide else LONG_SLIPS.firstOrNull { text.startsWith(it, position) }?.length ?: 0
}

private fun rightSpelling(written: String): String? =
    if (written[0] in WIDE_CHARACTERS) written.map { it - WIDE_OFFSET }.joinToString("") else RIGHT_SPELLINGS[written]

/** Reports the character at [range] of the line [text], which is no part of the language. */
internal fun DiagnosticSink.reportCharacter(text: String, range: SourceRange) {
    val written = text.substring(range.column - 1, range.endColumn - 1)
    val right = rightSpelling(written)
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

/** Whether a brace at [position] stands alone on its line, where other languages end a block. */
internal fun isOtherEnd(text: String, position: Int): Boolean =
    text[position] == '}' && text.indexOfFirst { !isBlank(it) } == position && isLast(text, position)

/** Whether nothing but a comment stands behind the character at [position]. */
private fun isLast(text: String, position: Int): Boolean {
    var next = position + 1
    while (next < text.length && isBlank(text[next])) next++
    return next == text.length || text.startsWith("//", next)
}

/** Words need a space between them and what is beside them, signs do not. */
private fun spaced(right: String, text: String, range: SourceRange): String {
    if (!isLetter(right[0])) return right
    val before = text.getOrNull(range.column - 2)?.let { if (isBlank(it)) "" else " " }.orEmpty()
    val behind = text.getOrNull(range.endColumn - 1)?.let { if (isBlank(it)) "" else " " }.orEmpty()
    return before + right + behind
}

/** Reports a text whose quotation marks, the first and the last character at [range], are not Robolang's. */
internal fun DiagnosticSink.reportOtherMarks(text: String, range: SourceRange) {
    val written = text.substring(range.column - 1, range.endColumn - 1)
    val wrong = if (written.first() == '"') written.last() else written.first()
    val fix = SourceFix(range, "\"" + written.substring(1, written.length - 1) + "\"")
    report(DiagnosticCode.UNKNOWN_CHARACTER, range, written, messages.characterInsteadOf(wrong.toString(), "\""), fix)
}

/** Reports a text whose closing quotation mark is missing. */
internal fun DiagnosticSink.reportUnclosedText(text: String, range: SourceRange) {
    val end = SourceRange(range.line, range.endColumn, range.endColumn)
    val written = text.substring(range.column - 1, range.endColumn - 1)
    report(DiagnosticCode.UNCLOSED_TEXT, range, written, messages.unclosedText(), SourceFix(end, "\""))
}
