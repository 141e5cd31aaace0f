package robotran.legofirmware.assembly

import robotran.language.source.Diagnostic
import robotran.legofirmware.image.LineTable
import robotran.legofirmware.image.RcxImage

/** The result of [assemble]. */
sealed interface AssemblyResult {
    /**
     * [image] can run.
     *
     * @property lines the line of each command.
     * @property warnings in source order.
     */
    class Success(val image: RcxImage, val lines: LineTable, val warnings: List<Diagnostic>) : AssemblyResult

    /** The text has mistakes; [diagnostics] are the errors in source order, never empty. */
    data class Failure(val diagnostics: List<Diagnostic>) : AssemblyResult
}
