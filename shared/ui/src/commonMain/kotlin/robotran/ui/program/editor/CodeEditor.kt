package robotran.ui.program.editor

import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.gestures.rememberScrollableState
import androidx.compose.foundation.gestures.scrollable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.offset
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusDirection
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalClipboardManager
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.platform.LocalSoftwareKeyboardController
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.CustomAccessibilityAction
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.IntOffset
import kotlinx.coroutines.delay
import org.jetbrains.compose.resources.stringResource
import robotran.editing.CodeLanguage
import robotran.editing.Draft
import robotran.editing.TextSelection
import robotran.editing.TextSpan
import robotran.editing.code.CodePieces
import robotran.programs.Mistake
import robotran.ui.resources.Res
import robotran.ui.resources.editor_breakpoint
import robotran.ui.resources.program_label
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.ProgramNote

/**
 * The text of a program to write in: only what is in sight is laid out and drawn, so that a long program is as quick to write in as a short one.
 *
 * @param hint what stands there as long as there is no text.
 * @param notes what is told about the lines, in their order.
 * @param pointedOut whether the first mistake is to stand out.
 * @param codeSize how large the text is, in sp.
 * @param onCommand does what concerns more than the text.
 * @param onBreakpoint is told the line, from 1, that somebody wants to stop before, or not any more.
 */
@Composable
internal fun CodeEditor(
    control: EditorControl,
    view: EditorView,
    draft: Draft,
    hint: String,
    marks: EditorMarks,
    notes: List<ProgramNote>,
    pointedOut: Boolean,
    codeSize: Float,
    focus: FocusRequester,
    onCommand: (EditorCommand) -> Unit,
    onBreakpoint: (Int) -> Unit,
    onZoom: (Float) -> Unit,
    onFix: (Mistake) -> Unit,
    modifier: Modifier = Modifier,
) {
    control.follow(draft)
    control.clipboard = LocalClipboardManager.current
    val layouts = rememberLineLayouts(control.language, codeSize)
    val pieces = remember(draft.lines, control.language) { CodePieces(draft.lines, control.language) }
    val hasFocus = control.hasFocus
    var composing by remember { mutableStateOf<TextSpan?>(null) }
    val shownNotes = notesBesideTyping(notes, draft, hasFocus && !pointedOut)
    val paint = remember(draft, marks, hasFocus, composing) { EditorPaint(draft, marks.copy(composing = composing), hasFocus) }
    val touch = rememberTouch(control, view, layouts, pieces, draft, focus, onBreakpoint, onZoom)
    KeepInSight(view, draft, layouts, pieces, marks.runningLine, hasFocus)
    Box(modifier) {
        EditorField(
            draft, control, view, layouts, { composing = it },
            Modifier.fillMaxSize().editorInput(control, focus, draft, onCommand, onBreakpoint) {
                control.hasFocus = it
                if (!it) {
                    control.isAtWork = false
                    control.closeOffered()
                }
            },
        )
        EditorSurface(
            paint, pieces, view, layouts, shownNotes.map { it.line ?: 1 },
            Modifier
                .fillMaxSize()
                .pointerHoverIcon(PointerIcon.Text)
                .pointerInput(touch) { listenForZoom(touch) }
                .scrolls(view)
                .pointerInput(touch) { listenFor(touch) },
        ) {
            val first = shownNotes.firstOrNull { !it.isDoubt }
            for (note in shownNotes) LineNote(note, pointedOut && note === first, onFix)
        }
        if (draft.text.isEmpty()) Hint(hint, codeSize, view)
        Overlays(control, view, draft, layouts, pieces, codeSize, hasFocus, onCommand)
    }
}

/** What a keyboard and a screen reader find in an editor. */
@Composable
private fun Modifier.editorInput(
    control: EditorControl,
    focus: FocusRequester,
    draft: Draft,
    onCommand: (EditorCommand) -> Unit,
    onBreakpoint: (Int) -> Unit,
    onFocus: (Boolean) -> Unit,
): Modifier {
    val label = stringResource(Res.string.program_label)
    val stopHere = stringResource(Res.string.editor_breakpoint)
    val focusManager = LocalFocusManager.current
    val line = draft.lines.lineOf(draft.selection.caret) + 1
    return focusRequester(focus)
        .onFocusChanged { onFocus(it.hasFocus) }
        .testTag("program")
        .semantics {
            contentDescription = label
            customActions = listOf(
                CustomAccessibilityAction(stopHere) {
                    onBreakpoint(line)
                    true
                },
            )
        }
        .onPreviewKeyEvent { event -> handleKey(event, control, onCommand) { focusManager.moveFocus(it) } }
}

private fun handleKey(
    event: KeyEvent,
    control: EditorControl,
    onCommand: (EditorCommand) -> Unit,
    onLeave: (FocusDirection) -> Unit,
): Boolean {
    val command = commandFor(event)
    val isEnter = event.key == Key.Enter || event.key == Key.NumPadEnter
    val isTab = event.key == Key.Tab
    if (event.type != KeyEventType.KeyDown) return isTab || (command != null && !leavesToField(command, control))
    if (control.performOnOffered(command, isEnter && command == null)) return true
    return when {
        isTab && !control.isAtWork -> {
            onLeave(if (command == EditorCommand.Plain.UNINDENT) FocusDirection.Previous else FocusDirection.Next)
            true
        }

        command == null || leavesToField(command, control) -> false

        command == EditorCommand.Plain.LEAVE -> {
            onCommand(command)
            control.isAtWork = false
            true
        }

        else -> {
            if (!control.perform(command)) onCommand(command)
            true
        }
    }
}

/** In a browser only the field itself may use the clipboard; it can where it holds all that is selected. */
private fun leavesToField(command: EditorCommand, control: EditorControl): Boolean =
    command in CLIPBOARD && control.link.holdsSelection

private val CLIPBOARD = setOf<EditorCommand>(EditorCommand.Plain.CUT, EditorCommand.Plain.COPY, EditorCommand.Plain.PASTE)

/** What a finger or a wheel scrolls. */
@Composable
internal fun Modifier.scrolls(view: EditorView): Modifier {
    val down = rememberScrollableState { -view.scrollDown(-it) }
    val right = rememberScrollableState { -view.scrollRight(-it) }
    return scrollable(down, Orientation.Vertical).scrollable(right, Orientation.Horizontal)
}

@Composable
private fun rememberTouch(
    control: EditorControl,
    view: EditorView,
    layouts: LineLayouts,
    pieces: CodePieces,
    draft: Draft,
    focus: FocusRequester,
    onBreakpoint: (Int) -> Unit,
    onZoom: (Float) -> Unit,
): EditorTouch {
    val keyboard = LocalSoftwareKeyboardController.current
    val now by rememberUpdatedState(Triple(draft, layouts, pieces))
    val breakpoint by rememberUpdatedState(onBreakpoint)
    val zoom by rememberUpdatedState(onZoom)
    return remember(control, view) {
        object : EditorTouch {
            override fun tapped(position: Offset, times: Int, selecting: Boolean, byFinger: Boolean) {
                val line = view.geometry.lineAt(position.y + view.scrollY) + 1
                if (position.x < view.gutter - GUTTER_EDGE) {
                    breakpoint(line)
                    return
                }
                focus.requestFocus()
                if (byFinger) keyboard?.show()
                control.isTouched = byFinger
                val offset = offsetAt(position)
                val isAgainAtCaret = byFinger && times == 1 && control.draft.selection == TextSelection(offset)
                control.tapped(offset, times, selecting)
                control.showsSelectionBar = byFinger && (times > 1 || isAgainAtCaret)
            }

            override fun longPressed(position: Offset) {
                focus.requestFocus()
                control.tapped(offsetAt(position), 2, selecting = false)
                control.showsSelectionBar = true
            }

            override fun draggedTo(position: Offset) {
                val hadBar = control.showsSelectionBar
                val beyond = position.y - position.y.coerceIn(0f, view.size.height.toFloat())
                if (beyond != 0f) view.scrollDown(beyond)
                control.tapped(offsetAt(position), 1, selecting = true)
                control.showsSelectionBar = hadBar
            }

            override fun zoomed(factor: Float) = zoom(factor)

            private fun offsetAt(position: Offset) = now.let { (text, lines, parts) -> view.offsetAt(position, text, lines, parts) }
        }
    }
}

@Composable
private fun KeepInSight(view: EditorView, draft: Draft, layouts: LineLayouts, pieces: CodePieces, runningLine: Int, hasFocus: Boolean) {
    LaunchedEffect(draft, view.size, layouts) {
        // The lines have their places only once they were laid out.
        withFrameNanos { }
        val line = draft.lines.lineOf(draft.selection.caret)
        if (!hasFocus && draft.selection.caret == 0 || line >= view.geometry.lines) return@LaunchedEffect
        val x = layouts.of(draft.lines.line(line), pieces.startsInComment(line)).x(draft.lines.columnOf(draft.selection.caret))
        view.bringIntoSight(line, x)
    }
    LaunchedEffect(runningLine) {
        if (runningLine == 0) return@LaunchedEffect
        delay(SLOW)
        if (runningLine <= view.geometry.lines) view.bringIntoSight(runningLine - 1, null)
    }
}

@Composable
private fun Hint(hint: String, size: Float, view: EditorView) {
    val colour = LocalRobotranColours.current.quiet
    val place = Modifier.offset { IntOffset(view.gutter.toInt(), 0) }.clearAndSetSemantics { }
    Text(hint, place, style = editorStyle(size).copy(color = colour))
}

@Composable
private fun Overlays(
    control: EditorControl,
    view: EditorView,
    draft: Draft,
    layouts: LineLayouts,
    pieces: CodePieces,
    codeSize: Float,
    hasFocus: Boolean,
    onCommand: (EditorCommand) -> Unit,
) {
    val place = { offset: Int ->
        val line = draft.lines.lineOf(offset).coerceAtMost(view.geometry.lines - 1)
        view.caretPlace(line, draft.lines.columnOf(offset), draft, layouts, pieces)
    }
    if (hasFocus && control.showsSelectionBar) {
        if (!draft.selection.isEmpty) {
            val drag = { keep: Int, at: Offset ->
                val offset = view.offsetAt(at, draft, layouts, pieces)
                if (offset != keep) {
                    control.write(draft.copy(selection = TextSelection(keep, offset)))
                    control.showsSelectionBar = true
                }
            }
            SelectionHandle({ place(draft.selection.anchor) }, "handle-anchor") { drag(draft.selection.caret, it) }
            SelectionHandle({ place(draft.selection.caret) }, "handle-caret") { drag(draft.selection.anchor, it) }
        }
        SelectionBar({ place(draft.selection.start) }) { if (!control.perform(it)) onCommand(it) }
    }
    val offered = control.offered
    if (hasFocus && offered != null) {
        CompletionPanel(offered, control.chosen, codeSize, { place(draft.selection.caret) }, control::takeOffered)
    }
}

/** [notes] without those of the line that somebody is typing in: it cannot be right yet. They come when the keys rest. */
@Composable
private fun notesBesideTyping(notes: List<ProgramNote>, draft: Draft, isWriting: Boolean): List<ProgramNote> {
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
        notes.filter { it.line != null && !(isTyping && it.line == caretLine) }.take(MOST_NOTES)
    }
}

/** Milliseconds without a key after which what is wrong with the line is told. */
private const val REST = 700L

/** Milliseconds that a line must take for the text to be scrolled to it. */
private const val SLOW = 150L

/** More mistakes at once help nobody. */
private const val MOST_NOTES = 30

/** Pixels left of the text that still belong to it. */
private const val GUTTER_EDGE = 4f
