package robotran.robolang.python

import robotran.language.source.SourceRange
import robotran.robolang.python.microbit.BoardRoom
import robotran.robolang.translate.LineMap

/**
 * A Robolang program as Python for a hub with Pybricks, or for a micro:bit.
 *
 * @property fileName such as `square.py`.
 * @property python the whole text. What does not go over is a comment there.
 * @property lineMap maps its lines to those of the program.
 * @property notes what is lost or different, each sentence once, in the order of the program.
 * @property room how full a micro:bit gets; null for a hub.
 */
class PythonTranslation internal constructor(
    val fileName: String,
    val python: String,
    val lineMap: LineMap,
    val notes: List<PythonNote>,
    val room: BoardRoom? = null,
) {
    /** Whether the Python does all that the program does. */
    val isComplete: Boolean get() = notes.none { it.isLost }
}

/**
 * What a hub or a board does not do like Robolang, or what is good to know.
 *
 * @property message one or two sentences in a pupil's words.
 * @property isLost whether the Python leaves it out; otherwise it does nearly the same.
 */
data class PythonNote(val range: SourceRange, val message: String, val isLost: Boolean)
