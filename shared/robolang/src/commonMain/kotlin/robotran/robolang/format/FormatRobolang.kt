package robotran.robolang.format

import robotran.brick.kind.BrickKind
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.Parser
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.brickIn
import robotran.robolang.syntax.scan

/**
 * Formats a Robolang program: two spaces of indentation per block, keywords in lower case, names as first written, one
 * space between tokens, comments of neighbouring lines aligned, no two empty lines in a row, and `
 * ` line ends. Keeps the meaning and every comment; formatting is idempotent. Undeclared names are no error here. Never
 * throws for any [source].
 *
 * @param messages the diagnostics in the pupil's language.
 */
fun formatRobolang(source: String, messages: RobolangMessages): FormatResult {
    val diagnostics = DiagnosticSink(messages)
    if (source.length > RobolangLimits.SOURCE_CHARACTERS) {
        val start = SourceRange(line = 1, column = 1, endColumn = 1)
        diagnostics.report(
            DiagnosticCode.SOURCE_TOO_LONG,
            start,
            "",
            messages.sourceTooLong(RobolangLimits.SOURCE_CHARACTERS),
        )
        return FormatResult.Failure(diagnostics.errorsInSourceOrder())
    }
    val lines = scan(source, diagnostics)
    diagnostics.brick = brickIn(lines) ?: BrickKind.default
    val parsed = Parser(lines, diagnostics).program()
    return if (diagnostics.isEmpty) {
        FormatResult.Success(layout(parsed))
    } else {
        FormatResult.Failure(diagnostics.errorsInSourceOrder())
    }
}
