package robotran.robolang.format

import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.diagnostic.SourceRange
import robotran.robolang.messages.EnglishRobolangMessages
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.Parser
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.scan

/**
 * Lays out a Robolang program: two spaces for each block around a line, keywords in lower case, names as they are first
 * written, one space between the pieces of a line, comments behind neighbouring lines one under the other, at most one
 * empty line at a time and `\n` at the end of each line. Means the same as before, keeps every comment, and formatted
 * again it stays as it is. Names that nothing declares are no mistake here. Never throws, whatever [source] holds.
 *
 * @param messages the language that mistakes are told in.
 */
fun formatRobolang(source: String, messages: RobolangMessages = EnglishRobolangMessages): FormatResult {
    val diagnostics = DiagnosticSink(messages)
    if (source.length > RobolangLimits.SOURCE_CHARACTERS) {
        val start = SourceRange(line = 1, column = 1, endColumn = 1)
        diagnostics.report(
            DiagnosticCode.SOURCE_TOO_LONG,
            start,
            "",
            messages.sourceTooLong(RobolangLimits.SOURCE_CHARACTERS),
        )
        return FormatResult.HasErrors(diagnostics.mistakesInSourceOrder())
    }
    val parsed = Parser(scan(source, diagnostics), diagnostics).program()
    return if (diagnostics.isEmpty) {
        FormatResult.Formatted(
            layout(parsed),
        )
    } else {
        FormatResult.HasErrors(diagnostics.mistakesInSourceOrder())
    }
}
