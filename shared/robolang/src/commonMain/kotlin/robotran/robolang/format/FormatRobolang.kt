package robotran.robolang.format

import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.Mistakes
import robotran.robolang.diagnostic.SourceRange
import robotran.robolang.messages.EnglishMessages
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.Parser
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.scan

/**
 * Lays out a Robolang program: two spaces for each block around a line, keywords in lower case, names as they are first written, one
 * space between the pieces of a line, comments behind neighbouring lines one under the other, at most one empty line at a time and
 * `\n` at the end of each line. Means the same as before, keeps every comment, and formatted again it stays as it is.
 * Names that nothing declares are no mistake here. Never throws, whatever [source] holds.
 *
 * @param messages the language that mistakes are told in.
 */
fun formatRobolang(source: String, messages: RobolangMessages = EnglishMessages): FormatResult {
    val mistakes = Mistakes(messages)
    if (source.length > RobolangLimits.SOURCE_CHARACTERS) {
        val start = SourceRange(line = 1, column = 1, endColumn = 1)
        mistakes.report(DiagnosticCode.SOURCE_TOO_LONG, start, "", messages.sourceTooLong(RobolangLimits.SOURCE_CHARACTERS))
        return FormatResult.Mistaken(mistakes.mistakesInSourceOrder())
    }
    val parsed = Parser(scan(source, mistakes), mistakes).program()
    return if (mistakes.isEmpty) FormatResult.Formatted(layout(parsed)) else FormatResult.Mistaken(mistakes.mistakesInSourceOrder())
}
