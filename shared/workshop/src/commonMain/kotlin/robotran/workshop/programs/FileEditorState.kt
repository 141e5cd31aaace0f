package robotran.workshop.programs

import robotran.projects.ProgramView
import robotran.textediting.EditHistory
import robotran.textediting.EditKind
import robotran.textediting.editBetween
import robotran.textediting.movedWith
import robotran.textediting.text.TextDocument
import robotran.workshop.blocks.BlocksState

/**
 * The editor state of a file.
 *
 * @property draft its text and selection.
 * @property history the edits for undo.
 * @property breakpoints lines, from 1, that a program stops before.
 * @property view how it is shown.
 * @property blocks its blocks as last shown; null if it was never shown in blocks.
 * @property undoBase the text and the history when the open sheet of [blocks] was opened: all that is done in a sheet is
 * undone together. Null if no such sheet is open.
 */
internal data class FileEditorState(
    val draft: TextDocument,
    val history: EditHistory = EditHistory(),
    val breakpoints: Set<Int> = emptySet(),
    val view: ProgramView = ProgramView.TEXT,
    val blocks: BlocksState? = null,
    val undoBase: UndoBase? = null,
) {
    /** The state after an edit to [written]. */
    fun written(written: TextDocument, kind: EditKind): FileEditorState {
        if (written.text == draft.text) {
            return copy(draft = draft.copy(selection = written.selection), history = history.closed())
                .withCursorAtCaret()
        }
        val recorded = history.recorded(draft, written, kind)
        return copy(draft = written, history = recorded, breakpoints = movedTo(written), undoBase = null)
    }

    fun undone(): FileEditorState? = history.undone(draft)?.let { (before, rest) ->
        copy(draft = before, history = rest, breakpoints = movedTo(before), undoBase = null)
    }

    fun redone(): FileEditorState? = history.redone(draft)?.let { (after, rest) ->
        copy(draft = after, history = rest, breakpoints = movedTo(after), undoBase = null)
    }

    fun withBreakpointToggled(line: Int): FileEditorState = when (line) {
        in breakpoints -> copy(breakpoints = breakpoints - line)
        in 1..draft.lines.count -> copy(breakpoints = breakpoints + line)
        else -> this
    }

    private fun movedTo(after: TextDocument): Set<Int> =
        editBetween(draft, after)?.let { breakpoints.movedWith(it, draft.lines) } ?: breakpoints
}

/** A text and how it came about. */
internal data class UndoBase(val draft: TextDocument, val history: EditHistory)
