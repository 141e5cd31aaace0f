package robotran.ui.program

import androidx.compose.ui.focus.FocusRequester
import robotran.language.source.Diagnostic
import robotran.language.source.SourceSpan
import robotran.textediting.EditKind
import robotran.textediting.find.nextMatch
import robotran.textediting.find.previousMatch
import robotran.textediting.find.withAllReplaced
import robotran.textediting.find.withSelected
import robotran.textediting.text.TextDocument
import robotran.ui.program.editor.EditorActions
import robotran.ui.program.editor.EditorCommand
import robotran.ui.program.editor.EditorControl
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.ProgramsState
import robotran.workshop.state.Settings

/**
 * The actions of keys and buttons that need more than the text: search, go to line, font size, and events for the state
 * holders.
 */
internal class PaneActions(
    private val control: EditorControl,
    private val find: FindState,
    private val focus: FocusRequester,
    private val state: () -> ProgramsState,
    private val settings: () -> Settings,
    private val onEvent: (WorkshopEvent) -> Unit,
    private val onRename: () -> Unit,
) : EditorActions,
    FindActions {
    var matches: List<SourceSpan> = emptyList()
    private var size = 0f

    override fun perform(command: EditorCommand.Plain) {
        when (command) {
            EditorCommand.Plain.UNDO -> onEvent(ProgramEvent.Undone)
            EditorCommand.Plain.REDO -> onEvent(ProgramEvent.Redone)
            EditorCommand.Plain.FORMAT -> onEvent(ProgramEvent.Formatted)
            EditorCommand.Plain.FIND, EditorCommand.Plain.REPLACE -> find.open(control.draft.selectedText)
            EditorCommand.Plain.FIND_NEXT -> next()
            EditorCommand.Plain.FIND_PREVIOUS -> previous()
            EditorCommand.Plain.TOGGLE_BREAKPOINT -> toggleBreakpoint(caretLine())
            EditorCommand.Plain.NEXT_NOTE -> goToNextNote()
            EditorCommand.Plain.FIX -> fixHere()
            EditorCommand.Plain.LARGER -> resize(settings().codeSize + STEP)
            EditorCommand.Plain.SMALLER -> resize(settings().codeSize - STEP)
            EditorCommand.Plain.DEFAULT_SIZE -> resize(Settings.DEFAULT_CODE_SIZE)

            EditorCommand.Plain.HELP -> onEvent(
                LearningEvent.HelpRequested(control.draft.text, control.draft.selection.caret),
            )

            EditorCommand.Plain.RENAME -> onRename()
            EditorCommand.Plain.LEAVE -> if (find.isOpen) close()
            else -> Unit
        }
    }

    override fun toggleBreakpoint(line: Int) = onEvent(ProgramEvent.BreakpointToggled(line))

    /** Shows help on [word]. */
    fun help(word: String) = onEvent(LearningEvent.HelpRequested(word, 0))

    override fun zoom(factor: Float) {
        val now = settings().codeSize
        if (size.toInt() != now.toInt()) size = now
        size = (size * factor).coerceIn(SIZES)
        if (size.toInt() != now.toInt()) resize(size.toInt().toFloat())
    }

    /**
     * Applies the fix of [diagnostic]. The pressed button disappears, so the focus returns to the text, but no
     * on-screen keyboard opens.
     */
    override fun fix(diagnostic: Diagnostic) {
        onEvent(ProgramEvent.FixApplied(diagnostic))
        if (control.hadFocus || !control.isPressedByFinger) focus.requestFocus()
    }

    /** Moves the caret to [line], from 1. */
    fun goToLine(line: Int) {
        val draft = control.draft
        if (line in 1..draft.lines.count) show(draft.withCaret(draft.lines.start(line - 1)))
    }

    /** Moves the caret to the next line with a diagnostic, in any file. */
    fun goToNextNote() {
        val now = state()
        val here = now.notes.filter {
            it.diagnostic.file == now.file.name
        }.mapNotNull { it.diagnostic.range }.sortedBy { it.line }
        val range = here.firstOrNull { it.line > caretLine() } ?: here.firstOrNull() ?: return
        val draft = control.draft
        if (range.line <= draft.lines.count) show(draft.withCaret(draft.lines.offset(range.line - 1, range.column - 1)))
        focus.requestFocus()
    }

    override fun next() = goTo(control.draft.nextMatch(matches))

    override fun previous() = goTo(control.draft.previousMatch(matches))

    override fun replaceOne() {
        val draft = control.draft
        val isAtMatch = matches.any { it.start == draft.selection.start && it.end == draft.selection.end }
        if (isAtMatch) control.write(draft.replaced(find.replacement), EditKind.OTHER)
        val after = control.draft
        val left = find.matchesIn(after.text)
        val place = after.nextMatch(left)
        if (place >= 0) show(after.withSelected(left[place]))
    }

    override fun replaceAll() {
        if (matches.isNotEmpty()) {
            control.write(
                control.draft.withAllReplaced(matches, find.replacement),
                EditKind.OTHER,
            )
        }
    }

    override fun close() {
        find.close()
        focus.requestFocus()
    }

    private fun goTo(index: Int) {
        if (index >= 0) show(control.draft.withSelected(matches[index]))
    }

    private fun show(draft: TextDocument) = control.write(draft)

    private fun caretLine(): Int = control.draft.lines.lineOf(control.draft.selection.caret) + 1

    private fun fixHere() {
        val here = state().notes.filter { it.line == caretLine() && it.diagnostic.file == state().file.name }
        here.firstOrNull { it.diagnostic.fix != null }?.let { fix(it.diagnostic) }
    }

    private fun resize(size: Float) =
        onEvent(SettingsEvent.SettingsChanged(settings().copy(codeSize = size.coerceIn(SIZES))))

    private companion object {
        const val STEP = 1f

        /** The range of [Settings.codeSize] in sp. */
        val SIZES = 10f..40f
    }
}
