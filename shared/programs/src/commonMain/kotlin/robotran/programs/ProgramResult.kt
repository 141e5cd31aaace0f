package robotran.programs

import robotran.rcxrom.program.RcxProgram

/** What came of reading a program. */
sealed interface ProgramResult {
    /**
     * [program] can be loaded into a brick. [warnings] are what is doubtful, in the order of the sources.
     *
     * @property mainClass the class that a program in Java begins with, with slashes; null of others.
     */
    data class Ready(
        val program: RcxProgram,
        val warnings: List<ProgramDiagnostic> = emptyList(),
        val mainClass: String? = null,
    ) : ProgramResult

    /** It cannot run; [diagnostics] are all there are, in the order of the sources, never empty. */
    data class HasErrors(val diagnostics: List<ProgramDiagnostic>) : ProgramResult
}
