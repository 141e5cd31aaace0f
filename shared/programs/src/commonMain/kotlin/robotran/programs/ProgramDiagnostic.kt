package robotran.programs

import robotran.robolang.diagnostic.SourceFix
import robotran.robolang.diagnostic.SourceRange

/**
 * An error or a warning in a program, written for beginners.
 *
 * @property file the file it is in; empty if the program has none.
 * @property range its position; null if it has none in the source.
 * @property message one or two sentences in plain words: what is wrong and what to do instead.
 * @property fix a change that very likely fixes it; null if there are several ways to.
 */
data class ProgramDiagnostic(
    val file: String,
    val range: SourceRange?,
    val message: String,
    val fix: SourceFix? = null,
)
