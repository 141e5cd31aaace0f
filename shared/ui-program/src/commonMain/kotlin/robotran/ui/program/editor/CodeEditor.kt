package robotran.ui.program.editor

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalClipboardManager
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.dp
import kotlinx.coroutines.delay
import robotran.language.source.SourceSpan
import robotran.languagesupport.CodeTokens
import robotran.programs.support
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import robotran.ui.program.tags.ProgramTags
import robotran.uikit.*
import robotran.workshop.state.InlineDiagnostic

/**
 * The code editor. It lays out and draws only the visible lines, so that editing long programs is as fast as short
 * ones.
 *
 * @param codeSize the font size in sp.
 */
@Composable
internal fun CodeEditor(
    control: EditorControl,
    text: EditorText,
    codeSize: Float,
    focus: FocusRequester,
    actions: EditorActions,
    modifier: Modifier = Modifier,
) {
    val view = control.view
    val draft = text.draft
    val marks = text.marks
    control.follow(draft)
    control.clipboard = LocalClipboardManager.current
    val brick = remember(draft.lines, control.brick) { control.syntax.brickOf(draft.lines) ?: control.brick }
    val layouts = rememberLineLayouts(control.language.support.code, brick, codeSize)
    val pieces = remember(draft.lines, control.language, brick) { CodeTokens(draft.lines, control.syntax, brick) }
    val hasFocus = control.hasFocus
    var composing by remember { mutableStateOf<SourceSpan?>(null) }
    val shownNotes = notesBesideTyping(text.notes, draft, hasFocus && !text.isErrorPointedOut)
    val paint =
        remember(draft, marks, hasFocus, composing) { EditorPaint(draft, marks.copy(composing = composing), hasFocus) }
    val onCommand = { command: EditorCommand -> if (command is EditorCommand.Plain) actions.perform(command) }
    val touch = rememberTouch(control, layouts, pieces, draft, focus, actions)
    KeepInSight(view, draft, layouts, marks, hasFocus)
    Box(modifier.padding(top = 6.dp)) {
        EditorField(
            draft,
            control,
            layouts,
            { caretBounds(view, draft, layouts, pieces, draft.selection.caret) },
            { composing = it },
            Modifier.fillMaxSize().editorInput(control, focus, draft, onCommand, actions::toggleBreakpoint) {
                control.hasFocus = it
                if (!it) {
                    control.isEditing = false
                    control.closeOffered()
                }
            },
        )
        EditorSurface(
            paint,
            pieces,
            view,
            layouts,
            shownNotes.map { it.line ?: 1 },
            Modifier
                .fillMaxSize()
                .pointerHoverIcon(PointerIcon.Text)
                .pointerInput(touch) { listenForZoom(touch) }
                .scrolls(view)
                .pointerInput(touch) { listenFor(touch) },
        ) {
            Notes(shownNotes, text, actions)
        }
        if (draft.text.isEmpty()) Hint(text.hint, codeSize, view)
        Overlays(control, view, draft, layouts, pieces, codeSize, hasFocus, onCommand)
    }
}

@Composable
private fun KeepInSight(
    view: EditorView,
    draft: TextDocument,
    layouts: LineLayouts,
    marks: EditorMarks,
    hasFocus: Boolean,
) {
    val runningLine = marks.runningLine
    LaunchedEffect(draft, view.size, view.columns, layouts) {
        // The lines have their positions only after layout.
        withFrameNanos { }
        val line = draft.lines.lineOf(draft.selection.caret)
        if ((!hasFocus && draft.selection.caret == 0) || line >= view.geometry.lines) return@LaunchedEffect
        view.scrollToCaret(line, draft.lines.columnOf(draft.selection.caret), draft)
    }
    LaunchedEffect(runningLine) {
        if (runningLine == 0) return@LaunchedEffect
        delay(SLOW)
        if (runningLine <= view.geometry.lines) view.scrollTo(runningLine - 1)
    }
    LaunchedEffect(marks.failedLine, view.size.height == 0) {
        if (marks.failedLine == 0) return@LaunchedEffect
        // The note below the line is measured only when it is first drawn.
        repeat(2) { withFrameNanos { } }
        if (marks.failedLine <= view.geometry.lines) view.scrollToNotes(marks.failedLine - 1)
    }
}

@Composable
private fun Notes(notes: List<InlineDiagnostic>, text: EditorText, actions: EditorActions) {
    val first = notes.firstOrNull { !it.isWarning }
    for (note in notes) {
        val standsOut = text.isErrorPointedOut && note === first
        LineNote(note, text.draft.lines.lineOfFix(note), standsOut, actions::fix)
    }
}

@Composable
private fun Hint(hint: String, size: Float, view: EditorView) {
    val colour = LocalRobotranColours.current.quiet
    val place = Modifier.offset { IntOffset(view.gutter.toInt(), 0) }.clearAndSetSemantics { }
    Text(hint, place, editorStyle(size).copy(color = colour))
}

@Composable
private fun Overlays(
    control: EditorControl,
    view: EditorView,
    draft: TextDocument,
    layouts: LineLayouts,
    pieces: CodeTokens,
    codeSize: Float,
    hasFocus: Boolean,
    onCommand: (EditorCommand) -> Unit,
) {
    val place = { offset: Int -> caretBounds(view, draft, layouts, pieces, offset) }
    if (hasFocus && control.showsSelectionBar) {
        if (!draft.selection.isEmpty) {
            val drag = { keep: Int, at: Offset ->
                val offset = view.offsetAt(at, draft, layouts, pieces)
                if (offset != keep) {
                    control.write(draft.copy(selection = TextSelection(keep, offset)))
                    control.showsSelectionBar = true
                }
            }
            SelectionHandle({
                place(draft.selection.anchor)
            }, ProgramTags.HANDLE_ANCHOR) { drag(draft.selection.caret, it) }
            SelectionHandle({
                place(draft.selection.caret)
            }, ProgramTags.HANDLE_CARET) { drag(draft.selection.anchor, it) }
        }
        SelectionBar({ place(draft.selection.start) }) { if (!control.perform(it)) onCommand(it) }
    }
    val completions = control.completions
    if (hasFocus && completions != null) {
        CompletionPanel(completions, control.chosen, codeSize, {
            place(draft.selection.caret)
        }, control::acceptCompletion)
    }
    if (hasFocus && control.hasNoCompletions) NoCompletions { place(draft.selection.caret) }
}

private fun caretBounds(
    view: EditorView,
    draft: TextDocument,
    layouts: LineLayouts,
    pieces: CodeTokens,
    offset: Int,
): Rect {
    val line = draft.lines.lineOf(offset).coerceAtMost(view.geometry.lines - 1)
    return view.caretBounds(line, draft.lines.columnOf(offset), draft, layouts, pieces)
}

/** [notes] without those of the line being typed, which is incomplete. They appear once typing pauses. */
@Composable
private fun notesBesideTyping(
    notes: List<InlineDiagnostic>,
    draft: TextDocument,
    isWriting: Boolean,
): List<InlineDiagnostic> {
    var restingText by remember { mutableStateOf(draft.text) }
    LaunchedEffect(draft.text) {
        if (restingText != draft.text) {
            delay(REST)
            restingText = draft.text
        }
    }
    val caretLine = draft.lines.lineOf(draft.selection.caret) + 1
    val isTyping = isWriting && draft.text != restingText
    return remember(notes, isTyping, if (isTyping) caretLine else 0) {
        notes.filter { it.line != null && !(isTyping && it.line == caretLine) }.take(MAX_NOTES)
    }
}

/** The pause in milliseconds after which the diagnostics of the line being typed appear. */
private const val REST = 700L

/** The min time in milliseconds that a line must run before the text scrolls to it. */
private const val SLOW = 150L

/** More errors at once are not useful. */
private const val MAX_NOTES = 30
