@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.window

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.text.input.CommitTextCommand
import androidx.compose.ui.text.input.EditCommand
import androidx.compose.ui.text.input.FinishComposingTextCommand
import androidx.compose.ui.text.input.ImeAction
import androidx.compose.ui.text.input.ImeOptions
import androidx.compose.ui.text.input.KeyboardType
import androidx.compose.ui.text.input.PlatformTextInputService
import androidx.compose.ui.text.input.SetComposingRegionCommand
import androidx.compose.ui.text.input.SetSelectionCommand
import androidx.compose.ui.text.input.TextFieldValue
import kotlinx.browser.document
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLTextAreaElement
import org.w3c.dom.events.Event
import robotran.projects.ProjectLimits

/**
 * A hidden browser field at the caret. It has the focus while a Compose text field has it, so on-screen keyboards,
 * input methods, dead keys, the clipboard and screen readers work. Every change of its text becomes an edit command.
 */
@Suppress("DEPRECATION")
internal class PageTextInput(
    place: HTMLElement,
    private val canvas: HTMLCanvasElement,
    private val density: () -> Float,
) : PlatformTextInputService {
    private class Session(
        val options: ImeOptions,
        val onEdit: (List<EditCommand>) -> Unit,
        val onAction: (ImeAction) -> Unit,
    )

    private val field = document.createElement("textarea") as HTMLTextAreaElement
    private var session: Session? = null
    private var value = TextFieldValue()
    private var composingFrom: Int? = null
    private var composed = ""

    init {
        for ((name, setting) in ATTRIBUTES) field.setAttribute(name, setting)
        for ((name, setting) in STYLE) field.style.setProperty(name, setting)
        place.appendChild(field)
    }

    /** Whether a Compose text field is receiving input. */
    val isOpen: Boolean get() = session != null

    /** Sets the field's label for screen readers. */
    fun call(label: String) {
        if (label != field.getAttribute("aria-label")) field.setAttribute("aria-label", label)
    }

    fun listen(keys: PageKeys) {
        keys.listenTo(field, isWrittenInto = true)
        field.addEventListener("beforeinput") { beforeInput(it) }
        field.addEventListener("input") { tellText() }
        field.addEventListener("paste") { pasted(it) }
        field.addEventListener("compositionstart") {
            composingFrom = field.selectionStart
            composed = ""
        }
        field.addEventListener("compositionupdate") { composed = dataOf(it) }
        field.addEventListener("compositionend") {
            composingFrom = null
            tellText()
        }
        document.addEventListener("selectionchange") { tellSelection() }
    }

    /** Keeps the focus when a pointer goes down outside the field. */
    fun keepFocus() {
        if (!isOpen) focusOn(canvas)
    }

    /** Replaces the selection by [text]. */
    fun insert(text: String) {
        if (!isOpen) return
        if (text.length > MAX_IN_FIELD) return rejectTooLong(text.take(MAX_IN_FIELD + 1))
        replaceSelection(field, text)
        tellText()
    }

    override fun startInput(
        value: TextFieldValue,
        imeOptions: ImeOptions,
        onEditCommand: (List<EditCommand>) -> Unit,
        onImeActionPerformed: (ImeAction) -> Unit,
    ) {
        session = Session(imeOptions, onEditCommand, onImeActionPerformed)
        composingFrom = null
        field.setAttribute("inputmode", if (imeOptions.keyboardType in NUMBERS) "decimal" else "text")
        field.setAttribute("enterkeyhint", if (imeOptions.singleLine) "done" else "enter")
        field.style.display = "block"
        this.value = value
        show()
        focusOn(field)
    }

    override fun stopInput() {
        session = null
        val hadFocus = document.activeElement == field
        field.style.display = "none"
        if (hadFocus) focusOn(canvas)
    }

    override fun showSoftwareKeyboard() {
        if (isOpen) focusOn(field)
    }

    override fun hideSoftwareKeyboard() {
        if (document.activeElement == field) focusOn(canvas)
    }

    override fun updateState(oldValue: TextFieldValue?, newValue: TextFieldValue) {
        value = newValue
        show()
    }

    override fun notifyFocusedRect(rect: Rect) {
        val scale = density()
        val left = (rect.left / scale).coerceIn(0f, (canvas.clientWidth - MIN).coerceAtLeast(0f))
        val top = (rect.top / scale).coerceIn(0f, (canvas.clientHeight - MIN).coerceAtLeast(0f))
        field.style.left = "${canvas.offsetLeft + left}px"
        field.style.top = "${canvas.offsetTop + top}px"
    }

    private fun show() {
        val selection = value.selection
        if (field.value != value.text) {
            field.value = value.text
            composingFrom = null
        } else if (composingFrom != null) {
            return
        }
        if (field.selectionStart != selection.min || field.selectionEnd != selection.max) {
            field.setSelectionRange(selection.min, selection.max, if (selection.reversed) "backward" else "forward")
        }
    }

    private fun beforeInput(event: Event) {
        val now = session ?: return
        if (!now.options.singleLine || kindOf(event) !in NEW_LINES) return
        event.preventDefault()
        now.onAction(now.options.imeAction)
    }

    private fun pasted(event: Event) {
        if (pastedLength(event) <= MAX_IN_FIELD) return
        event.preventDefault()
        rejectTooLong(pastedText(event, MAX_IN_FIELD + 1))
    }

    /** Browsers need minutes for millions of characters in a field. The Compose field rejects such a text itself. */
    private fun rejectTooLong(text: String) {
        session?.onEdit?.invoke(listOf(FinishComposingTextCommand(), CommitTextCommand(text, 1)))
    }

    private fun tellText() {
        val now = session ?: return
        val text = field.value
        val from = composingFrom
        val edits = buildList {
            add(FinishComposingTextCommand())
            if (text != value.text) {
                add(SetSelectionCommand(0, value.text.length))
                add(CommitTextCommand(text, 1))
            }
            add(SetSelectionCommand(field.selectionStart ?: 0, field.selectionEnd ?: 0))
            if (from != null) add(SetComposingRegionCommand(from, from + composed.length))
        }
        now.onEdit(edits)
    }

    /** On-screen keyboards also move the caret. */
    private fun tellSelection() {
        val now = session ?: return
        if (document.activeElement != field || composingFrom != null || field.value != value.text) return
        val start = field.selectionStart ?: return
        val end = field.selectionEnd ?: return
        if (start == value.selection.min && end == value.selection.max) return
        now.onEdit(listOf(SetSelectionCommand(start, end)))
    }

    private companion object {
        /** The max number of characters of any Compose field. */
        const val MAX_IN_FIELD = ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS

        /** CSS pixels between the field and the right and bottom edges. */
        const val MIN = 24f
        val NUMBERS = setOf(KeyboardType.Number, KeyboardType.Decimal)
        val NEW_LINES = setOf("insertLineBreak", "insertParagraph")
        val ATTRIBUTES = mapOf(
            "autocorrect" to "off",
            "autocomplete" to "off",
            "autocapitalize" to "off",
            "spellcheck" to "false",
            "wrap" to "off",
            "tabindex" to "-1",
        )

        /** Browsers zoom in on fields with a font size below 16 pixels. */
        val STYLE = mapOf(
            "position" to "absolute",
            "display" to "none",
            "width" to "1px",
            "height" to "20px",
            "margin" to "0",
            "padding" to "0",
            "border" to "none",
            "outline" to "none",
            "resize" to "none",
            "overflow" to "hidden",
            "opacity" to "0",
            "pointer-events" to "none",
            "font" to "16px monospace",
        )
    }
}

private fun focusOn(element: HTMLElement): Unit = js("element.focus({ preventScroll: true })")

private fun dataOf(event: Event): String = js("event.data || ''")

private fun kindOf(event: Event): String = js("event.inputType || ''")

private fun replaceSelection(field: HTMLTextAreaElement, text: String): Unit =
    js("field.setRangeText(text, field.selectionStart, field.selectionEnd, 'end')")

private fun pastedLength(event: Event): Int = js("event.clipboardData ? event.clipboardData.getData('text').length : 0")

private fun pastedText(event: Event, max: Int): String = js("event.clipboardData.getData('text').slice(0, max)")
