package robotran.textediting

import robotran.language.source.SourceSpan
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection

/**
 * The part of a long text that the input field holds. It gives on-screen keyboards and input methods a context, without
 * a layout of the whole text on every keystroke.
 *
 * @property span the part of the text.
 * @property containsSelection false if the selection is too long for the field. Then the field's whole text is selected,
 * and any input replaces the whole selection.
 */
data class InputWindow(val span: SourceSpan, val containsSelection: Boolean) {
    /** The field's text for [draft]. */
    fun textOf(draft: TextDocument): String = draft.text.substring(span.start, span.end)

    /** The field's selection for [draft]. */
    fun selectionOf(draft: TextDocument): TextSelection = if (containsSelection) {
        TextSelection(draft.selection.anchor - span.start, draft.selection.caret - span.start)
    } else {
        TextSelection(0, span.length)
    }

    /** Returns [draft] updated from the field's new [text] and [selection]. */
    fun applied(draft: TextDocument, text: String, selection: TextSelection): TextDocument {
        if (containsSelection) {
            val whole = draft.text.replaceRange(span.start, span.end, text)
            return TextDocument(whole, inWhole(selection, whole))
        }
        return when {
            text != textOf(draft) -> draft.replaced(text)
            selection == selectionOf(draft) -> draft
            else -> draft.copy(selection = inWhole(selection, draft.text))
        }
    }

    private fun inWhole(selection: TextSelection, text: String) =
        TextSelection(span.start + selection.anchor, span.start + selection.caret).within(text.length)

    /**
     * This window after [edit] if it can stay in place for [draft], because input methods expect a stable text; null
     * otherwise.
     */
    fun reusedFor(draft: TextDocument, edit: TextEdit?): InputWindow? {
        if (!containsSelection) return null
        val moved = if (edit == null) span else movedWith(edit) ?: return null
        val fits = moved.length in 0..2 * SIZE && moved.end <= draft.text.length
        val selected = draft.selection
        val roomBefore = moved.start == 0 || selected.start - moved.start >= MARGIN
        val roomBehind = moved.end == draft.text.length || moved.end - selected.end >= MARGIN
        val isInside = selected.start >= moved.start && selected.end <= moved.end
        return if (fits && isInside && roomBefore && roomBehind) copy(span = moved) else null
    }

    private fun movedWith(edit: TextEdit): SourceSpan? = when {
        edit.start >= span.start && edit.start + edit.removed.length <= span.end -> SourceSpan(
            span.start,
            span.end + edit.growth,
        )

        edit.start > span.end -> span
        edit.start + edit.removed.length < span.start -> SourceSpan(span.start + edit.growth, span.end + edit.growth)
        else -> null
    }

    companion object {
        /** The max length, in characters, of a text that the field holds whole. */
        const val MAX_WHOLE_LENGTH = 3_000

        /** The approximate length of a part, in characters. */
        const val SIZE = 1_200

        /** The min distance of the caret from the ends of a part, in characters. */
        const val MARGIN = 60

        /** Creates the window for [draft]. */
        fun of(draft: TextDocument): InputWindow {
            if (draft.text.length <= MAX_WHOLE_LENGTH) {
                return InputWindow(SourceSpan(0, draft.text.length), containsSelection = true)
            }
            val selection = draft.selection
            if (selection.end - selection.start > SIZE) {
                val start = selection.caret.coerceIn(selection.start, selection.end - PLACEHOLDER_LENGTH)
                return InputWindow(SourceSpan(start, start + PLACEHOLDER_LENGTH), containsSelection = false)
            }
            val from = lineStartBefore(draft, selection.start - SIZE / 2)
            val until = (selection.end + SIZE / 2).coerceAtMost(draft.text.length)
            return InputWindow(SourceSpan(from, until), containsSelection = true)
        }

        /** The length of the field's text if the selection is too long for it: enough for backspace to work. */
        private const val PLACEHOLDER_LENGTH = 40

        /** The start of the line of [offset], or [offset] itself in a very long line. */
        private fun lineStartBefore(draft: TextDocument, offset: Int): Int {
            val position = offset.coerceAtLeast(0)
            val start = draft.lines.start(draft.lines.lineOf(position))
            return if (position - start <= SIZE) start else position
        }
    }
}
