package robotran.languagesupport

import robotran.brick.kind.BrickKind

/**
 * Where somebody may want completions.
 *
 * @property caret the offset in the text of [lines].
 * @property isExplicit whether the pupil asked for completions; otherwise they are offered only after a typed character.
 * @property brick the brick of the robot; the program may name another.
 */
class CompletionRequest(
    val lines: TextLines,
    val caret: Int,
    val help: CompletionHelp,
    val isExplicit: Boolean,
    val brick: BrickKind,
) {
    /** The completions that begin at [start]; null if there are none or one of [candidates] is written already. */
    fun completions(start: Int, candidates: List<Completion>): CompletionList? {
        val typed = lines.text.substring(start, caret)
        if (!isExplicit && candidates.any { it.isWritten(typed) }) return null
        val items = matching(typed, candidates).filter { it.inserted != typed }
        return if (items.isEmpty()) null else CompletionList(start, items)
    }
}
