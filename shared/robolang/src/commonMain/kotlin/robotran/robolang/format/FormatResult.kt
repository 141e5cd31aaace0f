package robotran.robolang.format

import robotran.language.source.Diagnostic

/** The result of formatting a Robolang source. */
sealed interface FormatResult {
    /** [text] is the formatted program. */
    data class Success(val text: String) : FormatResult

    /** The source has syntax errors: [diagnostics], in source order, never empty. */
    data class Failure(val diagnostics: List<Diagnostic>) : FormatResult
}
