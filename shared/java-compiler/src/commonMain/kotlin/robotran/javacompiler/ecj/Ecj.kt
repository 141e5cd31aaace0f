package robotran.javacompiler.ecj

import robotran.languagesupport.SourceFile

/** The Eclipse compiler (ECJ) of this platform. Its messages are not yet worded for pupils. */
internal interface Ecj {
    /**
     * @param library the class files of the library of [target]; if it is the same map as in the last call for the
     * target, they are not read again.
     * @param gaps the keys of classes and members of [library] whose use is refused, see `EcjCompiler.addGap`.
     */
    fun compile(
        sources: List<SourceFile>,
        library: Map<String, ByteArray>,
        gaps: Set<String>,
        target: BrickTarget,
    ): EcjCompilation
}

/**
 * The result of an ECJ compilation.
 *
 * @property classes the class files by internal name.
 * @property mainClasses the classes with a main method.
 * @property completed false if the compiler failed because of an internal error.
 */
internal class EcjCompilation(
    val classes: Map<String, ByteArray>,
    val mainClasses: List<String>,
    val problems: List<EcjProblem>,
    val completed: Boolean,
)

/**
 * A problem that ECJ reports.
 *
 * @property number its kind, see [ProblemId].
 * @property isSyntax whether it is a syntax error.
 * @property start the offset of its first character in the text, from 0.
 * @property end the offset behind its last character.
 * @property message the compiler's own English sentence.
 * @property arguments the names and types it is about; their order depends on the kind.
 * @property members the names of the type's members, for a member that it does not have.
 */
internal class EcjProblem(
    val path: String,
    val number: Int,
    val isError: Boolean,
    val isSyntax: Boolean,
    val start: Int,
    val end: Int,
    val message: String,
    val arguments: List<String>,
    val members: List<String>,
)
