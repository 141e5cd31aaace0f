package robotran.ui.program.editor

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.isAltPressed
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import robotran.textediting.CaretMove

/** The command of a key or a shortcut in an editor. */
sealed interface EditorCommand {
    data class Move(val move: CaretMove, val selecting: Boolean) : EditorCommand

    data class ScrollLines(val lines: Int) : EditorCommand

    /** Commands without parameters. */
    enum class Plain : EditorCommand {
        UNDO,
        REDO,
        CUT,
        COPY,
        PASTE,
        SELECT_ALL,
        DOUBLE_LINES,
        DELETE_LINES,
        MOVE_LINES_UP,
        MOVE_LINES_DOWN,
        TOGGLE_COMMENT,
        ERASE_BACKWARDS,
        ERASE_FORWARDS,
        ERASE_WORD_BACKWARDS,
        ERASE_WORD_FORWARDS,
        INDENT,
        UNINDENT,
        FIND,
        REPLACE,
        FIND_NEXT,
        FIND_PREVIOUS,
        FORMAT,
        COMPLETE,
        TOGGLE_BREAKPOINT,
        NEXT_NOTE,
        FIX,
        LARGER,
        SMALLER,
        DEFAULT_SIZE,
        HELP,
        RENAME,
        LEAVE,
    }
}

/** The command of [event], a key down; null for text input. */
internal fun commandFor(event: KeyEvent): EditorCommand? {
    val control = event.isCtrlPressed || event.isMetaPressed
    val shift = event.isShiftPressed
    moveFor(event.key, control, event.isAltPressed)?.let { return EditorCommand.Move(it, shift) }
    return when {
        control && event.isAltPressed -> null
        event.isAltPressed -> ALT[event.key]?.takeIf { !shift || it == EditorCommand.Plain.FORMAT }
        control && shift -> CONTROL_SHIFT[event.key] ?: CONTROL[event.key].takeIf { it in SAME_WITH_SHIFT }
        control -> scrollFor(event.key) ?: CONTROL[event.key]
        shift -> SHIFT[event.key]
        else -> PLAIN[event.key]
    }
}

private fun moveFor(key: Key, control: Boolean, alt: Boolean): CaretMove? = when {
    alt -> null

    control -> when (key) {
        Key.DirectionLeft -> CaretMove.WORD_LEFT
        Key.DirectionRight -> CaretMove.WORD_RIGHT
        Key.MoveHome -> CaretMove.TEXT_START
        Key.MoveEnd -> CaretMove.TEXT_END
        else -> null
    }

    else -> MOVES[key]
}

private fun scrollFor(key: Key): EditorCommand? = when (key) {
    Key.DirectionUp -> EditorCommand.ScrollLines(-1)
    Key.DirectionDown -> EditorCommand.ScrollLines(1)
    else -> null
}

private val MOVES = mapOf(
    Key.DirectionLeft to CaretMove.LEFT,
    Key.DirectionRight to CaretMove.RIGHT,
    Key.DirectionUp to CaretMove.UP,
    Key.DirectionDown to CaretMove.DOWN,
    Key.PageUp to CaretMove.PAGE_UP,
    Key.PageDown to CaretMove.PAGE_DOWN,
    Key.MoveHome to CaretMove.LINE_START,
    Key.MoveEnd to CaretMove.LINE_END,
)

private val CONTROL = mapOf(
    Key.Z to EditorCommand.Plain.UNDO,
    Key.Y to EditorCommand.Plain.REDO,
    Key.X to EditorCommand.Plain.CUT,
    Key.C to EditorCommand.Plain.COPY,
    Key.V to EditorCommand.Plain.PASTE,
    Key.A to EditorCommand.Plain.SELECT_ALL,
    Key.D to EditorCommand.Plain.DOUBLE_LINES,
    Key.Slash to EditorCommand.Plain.TOGGLE_COMMENT,
    Key.NumPadDivide to EditorCommand.Plain.TOGGLE_COMMENT,
    Key.F to EditorCommand.Plain.FIND,
    Key.H to EditorCommand.Plain.REPLACE,
    Key.G to EditorCommand.Plain.FIND_NEXT,
    Key.Spacebar to EditorCommand.Plain.COMPLETE,
    Key.Period to EditorCommand.Plain.FIX,
    Key.Plus to EditorCommand.Plain.LARGER,
    Key.Equals to EditorCommand.Plain.LARGER,
    Key.NumPadAdd to EditorCommand.Plain.LARGER,
    Key.Minus to EditorCommand.Plain.SMALLER,
    Key.NumPadSubtract to EditorCommand.Plain.SMALLER,
    Key.Zero to EditorCommand.Plain.DEFAULT_SIZE,
    Key.NumPad0 to EditorCommand.Plain.DEFAULT_SIZE,
    Key.Backspace to EditorCommand.Plain.ERASE_WORD_BACKWARDS,
    Key.Delete to EditorCommand.Plain.ERASE_WORD_FORWARDS,
)

private val CONTROL_SHIFT = mapOf(
    Key.Z to EditorCommand.Plain.REDO,
    Key.G to EditorCommand.Plain.FIND_PREVIOUS,
    Key.F to EditorCommand.Plain.FORMAT,
    Key.K to EditorCommand.Plain.DELETE_LINES,
)

/** On some keyboards these characters need Shift. */
private val SAME_WITH_SHIFT =
    setOf(EditorCommand.Plain.LARGER, EditorCommand.Plain.TOGGLE_COMMENT, EditorCommand.Plain.DEFAULT_SIZE)

private val ALT = mapOf(
    Key.DirectionUp to EditorCommand.Plain.MOVE_LINES_UP,
    Key.DirectionDown to EditorCommand.Plain.MOVE_LINES_DOWN,
    Key.F to EditorCommand.Plain.FORMAT,
)

private val SHIFT = mapOf(
    Key.Tab to EditorCommand.Plain.UNINDENT,
    Key.F3 to EditorCommand.Plain.FIND_PREVIOUS,
    Key.Delete to EditorCommand.Plain.CUT,
    Key.Insert to EditorCommand.Plain.PASTE,
    Key.Backspace to EditorCommand.Plain.ERASE_BACKWARDS,
)

private val PLAIN = mapOf(
    Key.Tab to EditorCommand.Plain.INDENT,
    Key.Backspace to EditorCommand.Plain.ERASE_BACKWARDS,
    Key.Delete to EditorCommand.Plain.ERASE_FORWARDS,
    Key.Escape to EditorCommand.Plain.LEAVE,
    Key.F1 to EditorCommand.Plain.HELP,
    Key.F2 to EditorCommand.Plain.RENAME,
    Key.F3 to EditorCommand.Plain.FIND_NEXT,
    Key.F8 to EditorCommand.Plain.NEXT_NOTE,
    Key.F9 to EditorCommand.Plain.TOGGLE_BREAKPOINT,
)
