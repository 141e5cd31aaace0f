package robotran.javacompiler.diagnose

import robotran.language.source.SourceFix
import robotran.language.source.SourceSpan

/**
 * The explanation of a problem for the pupil.
 *
 * @property at the position in the source if it differs from the problem's own; empty where something is missing.
 */
internal class ProblemExplanation(
    val message: String,
    val hint: String? = null,
    val fix: SourceFix? = null,
    val at: SourceSpan? = null,
) {
    /** What is wrong and what to do instead. */
    val sentences: String get() = listOfNotNull(message, hint).joinToString(" ")
}
