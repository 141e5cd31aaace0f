package robotran.programs

import robotran.brick.program.BrickProgram
import robotran.language.source.Diagnostic

/** The result of compiling a program. */
sealed interface ProgramResult {
    /**
     * [program] can be loaded into a brick. The [warnings] are in the order of the sources.
     *
     * @property mainClass the main class of a program in Java, with slashes; null for other programs.
     */
    data class Success(
        val program: BrickProgram,
        val warnings: List<Diagnostic> = emptyList(),
        val mainClass: String? = null,
    ) : ProgramResult

    /** The program cannot run. The [diagnostics] are complete, in the order of the sources and never empty. */
    data class Failure(val diagnostics: List<Diagnostic>) : ProgramResult
}
