package robotran.textediting

import robotran.languagesupport.CodeSyntax
import robotran.textediting.text.TextDocument

/**
 * Keeps a long text and the small input field for the keyboard in step. It remembers the field's last content, so that
 * no input is lost when the pupil types faster than the screen is drawn. Not thread-safe.
 */
class InputLink(private val syntax: CodeSyntax) {
    private var shown = TextDocument("")
    private var window = InputWindow.of(shown)
    private var field = TextDocument("")

    /** The offset in the whole text at which the field's text begins. */
    val start: Int get() = window.span.start

    /** Whether the field holds the whole selection, so that its own clipboard commands can be used. */
    val containsSelection: Boolean get() = window.containsSelection

    /** Returns the text and selection that the field must show for [draft]. */
    fun fieldFor(draft: TextDocument): TextDocument {
        if (draft != shown) {
            val edit = editBetween(shown, draft)
            window = window.reusedFor(draft, edit) ?: InputWindow.of(draft)
            shown = draft
            field = TextDocument(window.textOf(draft), window.selectionOf(draft))
        }
        return field
    }

    /**
     * Returns [draft] updated from the field's new content, [written].
     *
     * @param isComposing whether an input method is composing a word.
     */
    fun received(draft: TextDocument, written: TextDocument, isComposing: Boolean): TextDocument {
        val before = field
        field = written
        val typed = typedBetween(before, written)
        val isInSync = draft == shown
        val after = when {
            typed != null && typed.isNotEmpty() && !isComposing -> draft.typed(typed, syntax)
            isInSync -> window.applied(draft, written.text, written.selection)
            typed != null -> draft.replaced(typed)
            written.text.length < before.text.length -> draft.erasedBackwards(syntax)
            else -> draft
        }
        if (isInSync) syncIfEqual(after)
        return after
    }

    /** Forgets the last input because the editor did not accept it; [fieldFor] then sets the field's content again. */
    fun forget() {
        shown = TextDocument("")
        window = InputWindow.of(shown)
        field = shown
    }

    /**
     * If the field already shows what it must show for [after], accepts it, so that more input can arrive before the
     * next frame.
     */
    private fun syncIfEqual(after: TextDocument) {
        val kept = window.reusedFor(after, editBetween(shown, after)) ?: return
        if (kept.textOf(after) != field.text || kept.selectionOf(after) != field.selection) return
        window = kept
        shown = after
    }
}
