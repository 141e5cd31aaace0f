package robotran.nqc

import robotran.language.source.Diagnostic

/** The result of [compileNqc]. */
sealed interface NqcResult {
    /** [program] can be loaded into a brick. [warnings] are in the order of the source, the main file first. */
    class Success(val program: NqcProgram, val warnings: List<Diagnostic>) : NqcResult

    /** The program has errors. [diagnostics] are in the order of the source and never empty. */
    class Failure(val diagnostics: List<Diagnostic>) : NqcResult
}
