package robotran.programs

import robotran.robolang.diagnostic.SourceFix
import robotran.robolang.diagnostic.SourceRange

/**
 * A mistake in a program of either language, or something doubtful, told so that a beginner can mend it.
 *
 * @property file the file it is in; empty if it is in none, as in a program without any.
 * @property range where it is; null if it is at no place of a source.
 * @property message one or two sentences in a learner's words, and what to do instead.
 * @property fix a change that very likely mends it, null where there are several ways.
 */
data class ProgramDiagnostic(
    val file: String,
    val range: SourceRange?,
    val message: String,
    val fix: SourceFix? = null,
)
