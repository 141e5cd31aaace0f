package robotran.robolang.syntax

import robotran.robolang.DiagnosticCode.UNKNOWN_CHARACTER
import robotran.robolang.Mistakes
import robotran.robolang.SourceFix
import robotran.robolang.SourceRange

/** What keyboards, word processors and other languages put where Robolang has a spelling of its own. */
private val RIGHT_SPELLINGS: Map<String, String> = mapOf(
    "\u2212" to "-",
    "\u2010" to "-",
    "\u2011" to "-",
    "\u2013" to "-",
    "\u2014" to "-",
    "\u00B0" to " degrees",
)

/** Reports the character at [range] of the line [text], which is no part of the language. */
internal fun Mistakes.reportCharacter(text: String, range: SourceRange) {
    val written = text.substring(range.column - 1, range.endColumn - 1)
    val right = RIGHT_SPELLINGS[written]
    val (message, replacement) = when {
        right != null -> messages.characterInsteadOf(written, right.trim()) to right
        written == ";" -> messages.semicolon() to ""
        written == "#" || written == "/" -> messages.commentBegins() to "//"
        written.length == 1 && isInvisible(written[0]) -> messages.invisibleCharacter(unicodeNumber(written[0])) to ""
        else -> messages.unknownCharacter(written) to null
    }
    report(UNKNOWN_CHARACTER, range, written, message, replacement?.let { SourceFix(range, it) })
}
