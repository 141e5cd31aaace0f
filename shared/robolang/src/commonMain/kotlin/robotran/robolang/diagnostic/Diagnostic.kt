package robotran.robolang.diagnostic

/**
 * A mistake in a program, or something doubtful, told so that a beginner can mend it.
 *
 * @property code says which kind of mistake it is and never changes for it, for tests and translations.
 * @property severity whether it keeps the program from running.
 * @property range where it is; of no width where something is missing.
 * @property text the piece of source it concerns, empty where something is missing.
 * @property message one or two sentences in a learner's words.
 * @property fix a change that very likely mends it, null where there are several ways.
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
 * @property range what is taken away; of no width where something is only put in.
 * @property replacement what is put in its place; may hold line ends, each `\n`.
 */
data class SourceFix(val range: SourceRange, val replacement: String)

/**
 * A piece of one line.
 *
 * @property line from 1.
 * @property column from 1, counted in UTF-16 characters, a tab being one; a byte order mark before the first line does
 * not count.
 * @property endColumn the column after the last character.
 */
data class SourceRange(val line: Int, val column: Int, val endColumn: Int)
