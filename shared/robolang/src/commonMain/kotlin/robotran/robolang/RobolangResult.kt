package robotran.robolang

import robotran.robolang.diagnostic.Diagnostic

/** What came of reading a Robolang source. */
sealed interface RobolangResult {
    /**
     * Nothing is wrong: [program] can be loaded into a brick. [warnings] are what is doubtful, in the order of the
     * source.
     */
    data class Ready(val program: RobolangProgram, val warnings: List<Diagnostic> = emptyList()) : RobolangResult

    /** It cannot run; [diagnostics] are all its mistakes, in the order of the source, never empty. */
    data class HasErrors(val diagnostics: List<Diagnostic>) : RobolangResult
}
