package robotran.robolang.format

import robotran.robolang.diagnostic.Diagnostic

/** What came of formatting a Robolang source. */
sealed interface FormatResult {
    /** [text] is the same program in the common layout. */
    data class Formatted(val text: String) : FormatResult

    /**
     * It cannot be read; [diagnostics] are the mistakes in its lines and blocks, in the order of the source, never
     * empty.
     */
    data class HasErrors(val diagnostics: List<Diagnostic>) : FormatResult
}
