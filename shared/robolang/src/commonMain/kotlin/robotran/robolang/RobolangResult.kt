package robotran.robolang

import robotran.language.source.Diagnostic

/** The result of compiling a Robolang source. */
sealed interface RobolangResult {
    /** The program has no errors: [program] can be loaded into a brick. [warnings] are in source order. */
    data class Success(val program: RobolangProgram, val warnings: List<Diagnostic> = emptyList()) : RobolangResult

    /** The program has errors and cannot run. [diagnostics] are all errors in source order; never empty. */
    data class Failure(val diagnostics: List<Diagnostic>) : RobolangResult
}
