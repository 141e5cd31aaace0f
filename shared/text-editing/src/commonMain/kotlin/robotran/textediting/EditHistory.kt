package robotran.textediting

import robotran.language.history.History
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection

/** The kind of an edit. Consecutive edits of the same kind can be undone together, except for `OTHER`. */
enum class EditKind { TYPING, ERASING, OTHER }

/**
 * The undo and redo history of a text. It is immutable: each call returns a new history. Continuous typing is undone
 * word by word, continuous erasing line by line. The oldest steps are dropped beyond the limits below.
 */
class EditHistory private constructor(private val steps: History<Step>) {
    constructor() : this(History())

    val canUndo: Boolean get() = steps.canUndo
    val canRedo: Boolean get() = steps.canRedo

    /** The history with the edit from [before] to [after] added. */
    fun recorded(before: TextDocument, after: TextDocument, kind: EditKind): EditHistory {
        val edit = editBetween(before, after) ?: return this
        val step = Step(edit, before.selection, after.selection, kind)
        val past = steps.past
        val joined = past.lastOrNull()?.joinedWith(step)
        val longer = if (joined == null) past + step else past.dropLast(1) + joined
        return EditHistory(History(withinLimits(longer)))
    }

    /** Undoes one step from [draft]; null if there is none. */
    fun undone(draft: TextDocument): Pair<TextDocument, EditHistory>? {
        val (step, rest) = steps.undone { it } ?: return null
        val text = step.edit.inverse.applyTo(draft.text)
        return TextDocument(text, step.before.within(text.length)) to EditHistory(rest)
    }

    /** Redoes one step from [draft]; null if nothing was undone. */
    fun redone(draft: TextDocument): Pair<TextDocument, EditHistory>? {
        // A redone step does not merge with the next edit.
        val (step, rest) = steps.redone { it.copy(kind = EditKind.OTHER) } ?: return null
        val text = step.edit.applyTo(draft.text)
        return TextDocument(text, step.after.within(text.length)) to EditHistory(rest)
    }

    /** This history, but the next edit starts a new step. */
    fun closed(): EditHistory {
        val last = steps.past.lastOrNull()?.takeIf { it.kind != EditKind.OTHER } ?: return this
        return EditHistory(steps.copy(past = steps.past.dropLast(1) + last.copy(kind = EditKind.OTHER)))
    }

    private data class Step(
        val edit: TextEdit,
        val before: TextSelection,
        val after: TextSelection,
        val kind: EditKind,
    ) {
        val size: Int get() = edit.inserted.length + edit.removed.length

        fun joinedWith(next: Step): Step? = when {
            kind != next.kind -> null

            kind == EditKind.TYPING && continuesTyping(next.edit) -> {
                joined(next, edit.copy(inserted = edit.inserted + next.edit.inserted))
            }

            kind == EditKind.ERASING && continuesErasing(next.edit) -> {
                joined(next, edit.copy(next.edit.start, next.edit.removed + edit.removed))
            }

            else -> null
        }

        private fun joined(next: Step, edit: TextEdit) = copy(edit = edit, after = next.after)

        private fun continuesTyping(next: TextEdit): Boolean {
            val startsWord =
                edit.inserted.lastOrNull()?.isWhitespace() == true &&
                    next.inserted.firstOrNull()?.isWhitespace() == false
            return next.removed.isEmpty() && next.start == edit.start + edit.inserted.length &&
                '\n' !in next.inserted &&
                !startsWord
        }

        private fun continuesErasing(next: TextEdit) =
            next.inserted.isEmpty() && edit.inserted.isEmpty() && next.start + next.removed.length == edit.start &&
                '\n' !in next.removed
    }

    companion object {
        /** The max number of steps. */
        const val MAX_STEPS = 400

        /** The max number of characters in all steps. The newest step is always kept. */
        const val MAX_CHARACTERS = 4_000_000

        private fun withinLimits(steps: List<Step>): List<Step> {
            var kept = steps.takeLast(MAX_STEPS)
            var size = kept.sumOf { it.size }
            while (size > MAX_CHARACTERS && kept.size > 1) {
                size -= kept.first().size
                kept = kept.drop(1)
            }
            return kept
        }
    }
}
