package robotran.textediting

import robotran.language.ProgramLanguage
import robotran.textediting.text.Draft

/**
 * Stands between a long text and a small input field that a keyboard writes into. It knows what the field last held, so
 * that nothing gets lost when somebody types faster than the screen is drawn. Not safe for use by several threads.
 */
class InputLink(private val language: ProgramLanguage) {
    private var shown = Draft("")
    private var window = InputWindow.of(shown)
    private var field = Draft("")

    /** Where the field's text begins in the whole. */
    val start: Int get() = window.span.start

    /** Whether all that is selected is in the field, so that its own clipboard can be used. */
    val holdsSelection: Boolean get() = window.holdsSelection

    /** What the field is to hold of [draft]. */
    fun fieldFor(draft: Draft): Draft {
        if (draft != shown) {
            val edit = editBetween(shown, draft)
            window = window.keptFor(draft, edit) ?: InputWindow.of(draft)
            shown = draft
            field = Draft(window.textOf(draft), window.selectionOf(draft))
        }
        return field
    }

    /**
     * What [draft] becomes now that the field holds [written].
     *
     * @param isComposing whether an input method is in the middle of a word.
     */
    fun received(draft: Draft, written: Draft, isComposing: Boolean): Draft {
        val before = field
        field = written
        val typed = typedBetween(before, written)
        val isInStep = draft == shown
        val after = when {
            typed != null && typed.isNotEmpty() && !isComposing -> draft.typed(typed, language)
            isInStep -> window.applied(draft, written.text, written.selection)
            typed != null -> draft.replaced(typed)
            written.text.length < before.text.length -> draft.erasedBackwards(language)
            else -> draft
        }
        if (isInStep) stayInStep(after)
        return after
    }

    /** What was received last did not become so: the field is to hold anew what it should. */
    fun forget() {
        shown = Draft("")
        window = InputWindow.of(shown)
        field = shown
    }

    /**
     * If the field holds of [after] just what it should, more can be received before anything is shown anew, whatever
     * it is.
     */
    private fun stayInStep(after: Draft) {
        val kept = window.keptFor(after, editBetween(shown, after)) ?: return
        if (kept.textOf(after) != field.text || kept.selectionOf(after) != field.selection) return
        window = kept
        shown = after
    }
}
