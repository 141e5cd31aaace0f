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
)

private const val DEGREE_SIGN = "\u00B0"

/** Reports the character at [range] of the line [text], which is no part of the language. */
internal fun Mistakes.reportCharacter(text: String, range: SourceRange) {
    val written = text.substring(range.column - 1, range.endColumn - 1)
    val right = RIGHT_SPELLINGS[written]
    when {
        right != null ->
            report(UNKNOWN_CHARACTER, range, written, messages.characterInsteadOf(written, right), SourceFix(range, right))
        written == DEGREE_SIGN ->
            report(UNKNOWN_CHARACTER, range, written, messages.characterInsteadOf(written, "degrees"), SourceFix(range, " degrees"))
        written == ";" ->
            report(UNKNOWN_CHARACTER, range, written, messages.semicolon(), SourceFix(range, ""))
        written == "#" || written == "/" ->
            report(UNKNOWN_CHARACTER, range, written, messages.commentBegins(), SourceFix(range, "//"))
        written.length == 1 && isInvisible(written[0]) ->
            report(UNKNOWN_CHARACTER, range, written, messages.invisibleCharacter(unicodeNumber(written[0])), SourceFix(range, ""))
        else ->
            report(UNKNOWN_CHARACTER, range, written, messages.unknownCharacter(written))
    }
}
