package robotran.robolang.syntax

import robotran.robolang.DiagnosticCode
import robotran.robolang.Mistakes
import robotran.robolang.SourceFix
import robotran.robolang.SourceRange

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
    "\u201C" to "\"",
    "\u201D" to "\"",
    "\u201E" to "\"",
    "'" to "\"",
    "\u00B0" to "degrees",
)

private val LONG_SLIPS: List<String> = RIGHT_SPELLINGS.keys.filter { it.length > 1 }

/** How long the sign of another language is that stands at [position] of [text] and begins like one of Robolang; 0 if none does. */
internal fun widthOfSlip(text: String, position: Int): Int =
    LONG_SLIPS.firstOrNull { text.startsWith(it, position) }?.length ?: 0

/** Reports the character at [range] of the line [text], which is no part of the language. */
internal fun Mistakes.reportCharacter(text: String, range: SourceRange) {
    val written = text.substring(range.column - 1, range.endColumn - 1)
    val right = RIGHT_SPELLINGS[written]
    val (message, replacement) = when {
        right != null -> messages.characterInsteadOf(written, right) to spaced(right, text, range)
        written == ";" -> messages.semicolon() to ""
        written == "#" -> messages.commentBegins() to "//"
        written.length == 1 && isInvisible(written[0]) -> messages.invisibleCharacter(unicodeNumber(written[0])) to ""
        else -> messages.unknownCharacter(written) to null
    }
    report(DiagnosticCode.UNKNOWN_CHARACTER, range, written, message, replacement?.let { SourceFix(range, it) })
}

/** Words need a space between them and what is beside them, signs do not. */
private fun spaced(right: String, text: String, range: SourceRange): String {
    if (!isLetter(right[0])) return right
    val before = text.getOrNull(range.column - 2)?.let { if (isBlank(it)) "" else " " }.orEmpty()
    val behind = text.getOrNull(range.endColumn - 1)?.let { if (isBlank(it)) "" else " " }.orEmpty()
    return before + right + behind
}

/** Reports a text whose closing quotation mark is missing. */
internal fun Mistakes.reportUnclosedText(text: String, range: SourceRange) {
    val end = SourceRange(range.line, range.endColumn, range.endColumn)
    val written = text.substring(range.column - 1, range.endColumn - 1)
    report(DiagnosticCode.UNCLOSED_TEXT, range, written, messages.unclosedText(), SourceFix(end, "\""))
}
