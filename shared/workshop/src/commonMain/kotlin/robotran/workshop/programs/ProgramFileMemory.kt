package robotran.workshop.programs

import robotran.textediting.EditHistory
import robotran.textediting.EditKind
import robotran.textediting.editBetween
import robotran.textediting.movedWith
import robotran.textediting.text.Draft

/**
 * The editor state of a file.
 *
 * @property draft its text and selection.
 * @property history the edits for undo.
 * @property breakpoints lines, from 1, that a program stops before.
 */
internal data class ProgramFileMemory(
    val draft: Draft,
    val history: EditHistory = EditHistory(),
    val breakpoints: Set<Int> = emptySet(),
) {
    /** The state after an edit to [written]. */
    fun written(written: Draft, kind: EditKind): ProgramFileMemory {
        if (written.text == draft.text) {
            return copy(draft = draft.copy(selection = written.selection), history = history.closed())
        }
        return copy(draft = written, history = history.recorded(draft, written, kind), breakpoints = movedTo(written))
    }

    fun undone(): ProgramFileMemory? = history.undone(draft)?.let { (before, rest) ->
        ProgramFileMemory(before, rest, movedTo(before))
    }

    fun redone(): ProgramFileMemory? = history.redone(draft)?.let { (after, rest) ->
        ProgramFileMemory(after, rest, movedTo(after))
    }

    fun withBreakpointToggled(line: Int): ProgramFileMemory = when (line) {
        in breakpoints -> copy(breakpoints = breakpoints - line)
        in 1..draft.lines.count -> copy(breakpoints = breakpoints + line)
        else -> this
    }

    private fun movedTo(after: Draft): Set<Int> =
        editBetween(draft, after)?.let { breakpoints.movedWith(it, draft.lines) } ?: breakpoints
}
