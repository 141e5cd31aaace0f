package robotran.textediting

import robotran.textediting.text.Draft
import robotran.textediting.text.TextSelection
import robotran.textediting.text.TextSpan

/**
 * The part of a long text that an input field holds, so that a keyboard on the screen and an input method have
 * something to work on, but not the whole text is laid out at every key.
 *
 * @property span which part it is.
 * @property holdsSelection false if more is selected than fits: then all of the field is selected, and whatever comes
 * instead replaces the whole selection.
 */
data class InputWindow(val span: TextSpan, val holdsSelection: Boolean) {
    /** What the field holds of [draft]. */
    fun textOf(draft: Draft): String = draft.text.substring(span.start, span.end)

    /** What is selected in the field. */
    fun selectionOf(draft: Draft): TextSelection = if (holdsSelection) {
        TextSelection(draft.selection.anchor - span.start, draft.selection.caret - span.start)
    } else {
        TextSelection(0, span.length)
    }

    /** What [draft] becomes when the field comes to hold [text] with [selection]. */
    fun applied(draft: Draft, text: String, selection: TextSelection): Draft {
        if (holdsSelection) {
            val whole = draft.text.replaceRange(span.start, span.end, text)
            return Draft(whole, inWhole(selection, whole))
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
     * This window after [edit], if it can stay where it is for [draft]; an input method does not like its text to move.
     */
    fun keptFor(draft: Draft, edit: TextEdit?): InputWindow? {
        if (!holdsSelection) return null
        val moved = if (edit == null) span else movedWith(edit) ?: return null
        val fits = moved.length in 0..2 * SIZE && moved.end <= draft.text.length
        val selected = draft.selection
        val roomBefore = moved.start == 0 || selected.start - moved.start >= MARGIN
        val roomBehind = moved.end == draft.text.length || moved.end - selected.end >= MARGIN
        val isInside = selected.start >= moved.start && selected.end <= moved.end
        return if (fits && isInside && roomBefore && roomBehind) copy(span = moved) else null
    }

    private fun movedWith(edit: TextEdit): TextSpan? = when {
        edit.start >= span.start && edit.start + edit.removed.length <= span.end -> TextSpan(
            span.start,
            span.end + edit.growth,
        )

        edit.start > span.end -> span

        edit.start + edit.removed.length < span.start -> TextSpan(span.start + edit.growth, span.end + edit.growth)

        else -> null
    }

    companion object {
        /** A text that is no longer than this, in characters, is held as a whole. */
        const val WHOLE = 3_000

        /** About how long a part is, in characters. */
        const val SIZE = 1_200

        /** How near the caret may come to the end of a part, in characters, before it becomes another. */
        const val MARGIN = 60

        /** The window for [draft]. */
        fun of(draft: Draft): InputWindow {
            if (draft.text.length <= WHOLE) return InputWindow(TextSpan(0, draft.text.length), holdsSelection = true)
            val selection = draft.selection
            if (selection.end - selection.start > SIZE) {
                val start = selection.caret.coerceIn(selection.start, selection.end - STUB)
                return InputWindow(TextSpan(start, start + STUB), holdsSelection = false)
            }
            val from = lineStartBefore(draft, selection.start - SIZE / 2)
            val until = (selection.end + SIZE / 2).coerceAtMost(draft.text.length)
            return InputWindow(TextSpan(from, until), holdsSelection = true)
        }

        /**
         * What the field holds of a selection that is too long for it; enough for an erasing key to have something to
         * erase.
         */
        private const val STUB = 40

        /** Where the line of [offset] begins, or [offset] itself in a very long line. */
        private fun lineStartBefore(draft: Draft, offset: Int): Int {
            val place = offset.coerceAtLeast(0)
            val start = draft.lines.start(draft.lines.lineOf(place))
            return if (place - start <= SIZE) start else place
        }
    }
}
