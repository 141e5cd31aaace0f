package robotran.ui.program.editor

import androidx.compose.runtime.Stable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.platform.ClipboardManager
import androidx.compose.ui.text.AnnotatedString
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.languagesupport.Completion
import robotran.languagesupport.CompletionHelp
import robotran.languagesupport.CompletionList
import robotran.programs.support
import robotran.textediting.CaretMove
import robotran.textediting.EditKind
import robotran.textediting.InputLink
import robotran.textediting.complete.completed
import robotran.textediting.complete.completionsAt
import robotran.textediting.erasedBackwards
import robotran.textediting.erasedForwards
import robotran.textediting.indented
import robotran.textediting.moved
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import robotran.textediting.text.withWordSelected
import robotran.textediting.typed
import robotran.textediting.unindented
import robotran.textediting.withCommentToggled
import robotran.textediting.withLinesDuplicated
import robotran.textediting.withLinesMovedDown
import robotran.textediting.withLinesMovedUp
import robotran.textediting.withoutLines
import robotran.textediting.wordErasedBackwards
import robotran.textediting.wordErasedForwards

/**
 * The input logic of the editor for one file. It always has the newest text, even if several keys arrive between two
 * frames.
 *
 * @param hasRoom whether the text may change like this.
 * @param onWritten receives the new text, also if it was rejected.
 */
@Stable
internal class EditorControl(
    val language: ProgramLanguage,
    val view: EditorView,
    var brick: BrickKind,
    private val hasRoom: (TextDocument) -> Boolean = { true },
    private val onWritten: (TextDocument, EditKind) -> Unit,
) {
    val syntax = language.support.code
    val link = InputLink(syntax)
    var draft = TextDocument("")
        private set
    var help: CompletionHelp = CompletionHelp { null }
    lateinit var clipboard: ClipboardManager

    /** The completions at the caret and the selected one; null if none are shown. */
    var completions: CompletionList? by mutableStateOf(null)
        private set
    var chosen by mutableStateOf(0)
        private set

    /** Whether the user requested completions where there are none. */
    var hasNoCompletions by mutableStateOf(false)
        private set

    /** Whether the user is editing, so that Tab indents; otherwise Tab moves the focus. */
    var isEditing by mutableStateOf(false)

    /** Whether the editor has the keyboard focus. */
    var hasFocus by mutableStateOf(false)

    /** Whether the last input was a touch, so that the keyboard is probably on screen. */
    var isTouched by mutableStateOf(false)

    /** Whether the last press anywhere in the editor was a touch, and whether the editor had the focus then. */
    var isPressedByFinger = false
    var hadFocus = false

    /** Whether the buttons for a selection by touch are shown. */
    var showsSelectionBar by mutableStateOf(false)

    private var goal: Int? = null

    /** Sets the text to [draft] after a change from outside. */
    fun follow(draft: TextDocument) {
        if (draft.text != this.draft.text) closeOffered()
        this.draft = draft
    }

    /** Called when the input field changes to [field]. */
    fun received(field: TextDocument, isComposing: Boolean) {
        val before = draft
        val after = link.received(before, field, isComposing)
        if (after == before) return
        val kind = when {
            after.text.length > before.text.length -> EditKind.TYPING
            after.text.length < before.text.length -> EditKind.ERASING
            else -> EditKind.OTHER
        }
        write(after, kind)
        if (draft.text != before.text) offer(draft, kind == EditKind.TYPING)
    }

    fun write(after: TextDocument, kind: EditKind = EditKind.OTHER) {
        isEditing = true
        goal = null
        closeOffered()
        showsSelectionBar = false
        if (hasRoom(after)) draft = after else link.forget()
        onWritten(after, kind)
    }

    /** Shows all completions at the caret, regardless of what was typed. */
    fun showAllCompletions() {
        if (!draft.selection.isEmpty) write(draft.withCaret(draft.selection.end))
        completions = completionsAt(draft, syntax, help, isExplicit = true, brick)
        hasNoCompletions = completions == null
        chosen = 0
    }

    fun acceptCompletion(completion: Completion) {
        val list = completions ?: return
        write(draft.completed(list, completion))
        // Some words are only the first of a phrase.
        if (completion.offersNext) offer(draft, isTyping = true, isExplicit = true)
    }

    fun closeOffered() {
        completions = null
        hasNoCompletions = false
    }

    /** Types [text] like a key. */
    fun type(text: String) = write(draft.typed(text, syntax), EditKind.TYPING)

    /** Performs [command]; false if it concerns more than the text. */
    fun perform(command: EditorCommand): Boolean {
        when (command) {
            is EditorCommand.Move -> move(command)
            is EditorCommand.ScrollLines -> view.scrollDown(command.lines * view.geometry.lineHeight)
            is EditorCommand.Plain -> return performPlain(command)
        }
        return true
    }

    /** Handles the keys of an open completion list; false if [command] is not one of them. */
    fun performOnOffered(command: EditorCommand?, isEnter: Boolean): Boolean {
        if (hasNoCompletions && command == EditorCommand.Plain.LEAVE) {
            closeOffered()
            return true
        }
        val list = completions ?: return false
        when {
            command == EditorCommand.Move(CaretMove.DOWN, false) -> chosen = (chosen + 1) % list.items.size

            command == EditorCommand.Move(CaretMove.UP, false) -> {
                chosen = (chosen + list.items.size - 1) % list.items.size
            }

            isEnter || command == EditorCommand.Plain.INDENT -> acceptCompletion(list.items[chosen])
            command == EditorCommand.Plain.LEAVE -> closeOffered()
            else -> return false
        }
        return true
    }

    private fun performPlain(command: EditorCommand.Plain): Boolean {
        when (command) {
            EditorCommand.Plain.SELECT_ALL -> write(draft.copy(selection = TextSelection(0, draft.text.length)))
            EditorCommand.Plain.CUT -> cut()
            EditorCommand.Plain.COPY -> copy()
            EditorCommand.Plain.PASTE -> clipboard.getText()?.let { type(it.text) }
            EditorCommand.Plain.DOUBLE_LINES -> write(draft.withLinesDuplicated())
            EditorCommand.Plain.DELETE_LINES -> write(draft.withoutLines())
            EditorCommand.Plain.MOVE_LINES_UP -> write(draft.withLinesMovedUp())
            EditorCommand.Plain.MOVE_LINES_DOWN -> write(draft.withLinesMovedDown())
            EditorCommand.Plain.TOGGLE_COMMENT -> write(draft.withCommentToggled(syntax))
            EditorCommand.Plain.ERASE_BACKWARDS -> erase(draft.erasedBackwards(syntax))
            EditorCommand.Plain.ERASE_FORWARDS -> erase(draft.erasedForwards())
            EditorCommand.Plain.ERASE_WORD_BACKWARDS -> erase(draft.wordErasedBackwards())
            EditorCommand.Plain.ERASE_WORD_FORWARDS -> erase(draft.wordErasedForwards())
            EditorCommand.Plain.INDENT -> indent()
            EditorCommand.Plain.UNINDENT -> write(draft.unindented(syntax))
            EditorCommand.Plain.COMPLETE -> showAllCompletions()
            else -> return false
        }
        return true
    }

    private fun indent() {
        if (draft.selection.isEmpty) {
            val column = draft.lines.columnOf(draft.selection.caret)
            type(" ".repeat(syntax.indent.length - column % syntax.indent.length))
        } else {
            write(draft.indented(syntax))
        }
    }

    private fun erase(after: TextDocument) {
        if (after == draft) return
        val wasOffered = completions != null
        write(after, EditKind.ERASING)
        if (wasOffered) offer(draft, isTyping = true)
    }

    private fun cut() {
        copy()
        if (!draft.selection.isEmpty) write(draft.replaced(""))
    }

    private fun copy() {
        if (!draft.selection.isEmpty) clipboard.setText(AnnotatedString(draft.selectedText))
        showsSelectionBar = false
    }

    private fun move(command: EditorCommand.Move) {
        val isVertical = command.move in VERTICAL
        val rows = view.rows(draft.lines)
        val cell = if (isVertical) goal ?: rows.cellOf(draft.selection.caret) else null
        val after = draft.moved(command.move, command.selecting, cell, view.page, rows)
        if (after != draft) write(after) else isEditing = true
        goal = cell
    }

    private fun offer(after: TextDocument, isTyping: Boolean, isExplicit: Boolean = false) {
        val list = if (isTyping) completionsAt(after, syntax, help, isExplicit, brick) else null
        val isMember = list != null && after.text.getOrNull(list.start - 1) == '.'
        completions = list?.takeIf { isMember || isExplicit || after.selection.caret - it.start >= MIN_TYPED }
        chosen = 0
    }

    /** Handles taps: moves the caret, or selects a word or a line. */
    fun tapped(offset: Int, times: Int, selecting: Boolean) {
        val after = when {
            selecting -> draft.copy(selection = TextSelection(draft.selection.anchor, offset))
            times == 2 -> draft.withWordSelected(offset)
            times > 2 -> draft.withLineSelected(draft.lines.lineOf(offset))
            else -> draft.withCaret(offset)
        }
        write(after)
    }

    private fun TextDocument.withLineSelected(line: Int) =
        copy(selection = TextSelection(lines.start(line), lines.end(line)))

    private companion object {
        val VERTICAL = setOf(CaretMove.UP, CaretMove.DOWN, CaretMove.PAGE_UP, CaretMove.PAGE_DOWN)

        /** Fewer characters give too many completions. */
        const val MIN_TYPED = 2
    }
}
