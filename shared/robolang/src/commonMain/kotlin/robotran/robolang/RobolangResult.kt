package robotran.robolang

/** What came of reading a Robolang source. */
sealed interface RobolangResult {
    /** There is nothing wrong with it: [program] can be loaded into a brick. */
    data class Ready(val program: RobolangProgram) : RobolangResult

    /** It cannot run; [diagnostics] are all its mistakes, in the order of the source, never empty. */
    data class Mistaken(val diagnostics: List<Diagnostic>) : RobolangResult
}
