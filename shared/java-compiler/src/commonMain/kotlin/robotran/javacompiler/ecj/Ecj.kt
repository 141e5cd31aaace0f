package robotran.javacompiler.ecj

/** The Eclipse compiler as the platform has it; what it says is not yet in a pupil's words. */
internal interface Ecj {
    fun compile(sources: List<JavaSource>, library: Map<String, ByteArray>): EcjCompilation
}

/**
 * What the Eclipse compiler made of some sources.
 *
 * @property classes the class files by internal name.
 * @property mainClasses those with a main method.
 * @property completed false if the compiler gave up because of a mistake of its own.
 */
internal class EcjCompilation(
    val classes: Map<String, ByteArray>,
    val mainClasses: List<String>,
    val problems: List<EcjProblem>,
    val completed: Boolean,
)

/**
 * Something that the Eclipse compiler finds wrong.
 *
 * @property number its kind, see [ProblemNumber].
 * @property isSyntax whether the source could not even be read there.
 * @property start the place of its first character in the text, from 0.
 * @property end the place behind the last one.
 * @property message the compiler's own English sentence.
 * @property arguments the names and types it is about; their order depends on the kind.
 * @property members the names that the type in question does have, for one that it has not.
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
