package robotran.javacompiler

import robotran.javacompiler.ecj.BrickTarget
import robotran.language.source.Diagnostic

/** The result of a compilation. */
sealed interface CompilationResult {
    /**
     * The program can be loaded into a brick if it links with the brick's virtual machine.
     *
     * @property classes the class files by internal name, such as `robots/Square`, in the order of the sources; their
     * version is that of the [BrickTarget].
     * @property warnings the warnings in the order of the sources.
     * @property mainClasses the names of the classes with a `public static void main(String[])`; may be empty.
     * @property missingMain the error to report if the caller wants to run a program without a main method; null if
     * there is one or there are no sources.
     */
    class Success(
        val classes: Map<String, ByteArray>,
        val warnings: List<Diagnostic>,
        val mainClasses: List<String>,
        val missingMain: Diagnostic?,
    ) : CompilationResult

    /** The program cannot run. The [diagnostics] are all its errors, in the order of the sources and never empty. */
    data class Failure(val diagnostics: List<Diagnostic>) : CompilationResult
}
