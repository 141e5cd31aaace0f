package robotran.robolang

/**
 * A mistake in a program, told so that a beginner can mend it.
 *
 * @property code says which kind of mistake it is and never changes for it, for tests and translations.
 * @property range where it is.
 * @property text the piece of source it concerns, empty where something is missing.
 * @property message one sentence in a learner's words.
 */
data class Diagnostic(
    val code: DiagnosticCode,
    val range: SourceRange,
    val text: String,
    val message: String,
)

/**
 * A piece of one line.
 *
 * @property line from 1.
 * @property column from 1, counted in UTF-16 characters, a tab being one.
 * @property endColumn the column after the last character.
 */
data class SourceRange(
    val line: Int,
    val column: Int,
    val endColumn: Int,
)
