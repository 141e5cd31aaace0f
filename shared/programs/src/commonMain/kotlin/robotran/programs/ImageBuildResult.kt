package robotran.programs

import robotran.language.source.Diagnostic
import robotran.lejoslinker.LejosImage

/** The result of [ProgramCompiler.buildImage]. */
sealed interface ImageBuildResult {
    /**
     * [image] can be sent to a brick.
     *
     * @property warnings about the programs, and about the little memory that they leave.
     */
    class Success(val image: LejosImage, val warnings: List<Diagnostic>) : ImageBuildResult

    /** A brick cannot run the programs. The [diagnostics] are in the order of the programs and never empty. */
    data class Failure(val diagnostics: List<Diagnostic>) : ImageBuildResult

    /** The Java compiler could not be loaded; see [CompilerLoading.Failure]. */
    class NotLoaded(val cause: Throwable) : ImageBuildResult
}
