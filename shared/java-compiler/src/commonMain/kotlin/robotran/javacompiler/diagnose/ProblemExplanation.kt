package robotran.javacompiler.diagnose

/**
 * What to tell about a problem.
 *
 * @property at the place in the source that it is about, if it is not the problem's own; of no width where something is
 * missing.
 */
internal class ProblemExplanation(
    val message: String,
    val hint: String? = null,
    val fix: JavaFix? = null,
    val at: SourceSpan? = null,
)

/** A piece of a source, from the character [start], counted from 0, to before [end]. */
internal class SourceSpan(val start: Int, val end: Int = start)
