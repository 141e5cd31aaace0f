package robotran.robolang.format

import robotran.language.source.Diagnostic

/** The result of formatting a Robolang source. */
sealed interface FormatResult {
    /** [text] is the formatted program. */
    data class Formatted(val text: String) : FormatResult

    /** The source has syntax errors: [diagnostics], in source order, never empty. */
    data class HasErrors(val diagnostics: List<Diagnostic>) : FormatResult
}
