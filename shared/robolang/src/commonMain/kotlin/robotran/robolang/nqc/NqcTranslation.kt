package robotran.robolang.nqc

import robotran.language.source.SourceRange
import robotran.robolang.translate.LineMap

/**
 * A Robolang program as NQC for an RCX with LEGO's firmware 2.0.
 *
 * @property fileName such as `square.nqc`.
 * @property nqc the whole text. What does not go over is a comment there.
 * @property lineMap maps its lines to those of the program.
 * @property notes what is lost or changed, in the order of the program.
 */
class NqcTranslation internal constructor(
    val fileName: String,
    val nqc: String,
    val lineMap: LineMap,
    val notes: List<NqcTranslationNote>,
) {
    /** Whether the NQC does all that the program does. */
    val isComplete: Boolean get() = notes.none { it.isLost }
}

/**
 * What NQC cannot do like Robolang.
 *
 * @property message one or two sentences in a pupil's words.
 * @property isLost whether the NQC leaves it out; otherwise it does nearly the same.
 */
data class NqcTranslationNote(val range: SourceRange, val message: String, val isLost: Boolean)
