package robotran.javacompiler.diagnose

/**
 * The explanation of a problem for the pupil.
 *
 * @property at the position in the source if it differs from the problem's own; empty where something is missing.
 */
internal class ProblemExplanation(
    val message: String,
    val hint: String? = null,
    val fix: JavaFix? = null,
    val at: SourceSpan? = null,
)

/** The part of a source from offset [start], from 0, to before [end]. */
internal class SourceSpan(val start: Int, val end: Int = start)
