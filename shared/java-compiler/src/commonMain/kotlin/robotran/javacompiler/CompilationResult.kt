package robotran.javacompiler

import robotran.javacompiler.diagnose.JavaDiagnostic

/** What came of compiling a program. */
sealed interface CompilationResult {
    /**
     * The program can be loaded into a brick, if its class files have all that the brick's virtual machine needs.
     *
     * @property classes the class files by internal name, such as `robots/Square`, in the order of the sources; version
     * 45.3.
     * @property warnings what is doubtful, in the order of the sources.
     * @property mainClasses the names of the classes with a `public static void main(String[])`; there may be none.
     * @property missingMain the mistake that there is none, for whoever wants to run the program; null if there is one,
     * or no source at all.
     */
    class Compiled(
        val classes: Map<String, ByteArray>,
        val warnings: List<JavaDiagnostic>,
        val mainClasses: List<String>,
        val missingMain: JavaDiagnostic?,
    ) : CompilationResult

    /** It cannot run; [diagnostics] are all its mistakes, in the order of the sources, never empty. */
    data class Rejected(val diagnostics: List<JavaDiagnostic>) : CompilationResult
}
