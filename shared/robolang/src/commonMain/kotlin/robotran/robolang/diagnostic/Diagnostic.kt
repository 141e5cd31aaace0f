package robotran.robolang.diagnostic

/**
 * An error or a warning about a program, in words that a beginner understands.
 *
 * @property code the kind of problem; stable, for tests and translations.
 * @property severity whether it prevents the program from running.
 * @property range its position; zero-width if something is missing.
 * @property text the source text at [range]; empty if something is missing.
 * @property message one or two sentences in a learner's words.
 * @property fix a change that very likely fixes it; null if there are several ways.
 */
data class Diagnostic(
    val code: DiagnosticCode,
    val severity: Severity,
    val range: SourceRange,
    val text: String,
    val message: String,
    val fix: SourceFix? = null,
)

/**
 * A change of the source that an editor can offer.
 *
 * @property range the text to remove; zero-width to only insert.
 * @property replacement the text to insert; line ends are `
 * `.
 */
data class SourceFix(val range: SourceRange, val replacement: String)

/**
 * A range within one line.
 *
 * @property line from 1.
 * @property column from 1, in UTF-16 characters; a tab counts as one, a byte order mark before the first line does not
 * count.
 * @property endColumn the column after the last character.
 */
data class SourceRange(val line: Int, val column: Int, val endColumn: Int)
