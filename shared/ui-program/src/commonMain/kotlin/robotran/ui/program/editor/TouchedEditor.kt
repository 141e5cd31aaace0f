package robotran.ui.program.editor

import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.gestures.rememberScrollableState
import androidx.compose.foundation.gestures.scrollable
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.platform.LocalSoftwareKeyboardController
import robotran.languagesupport.CodeTokens
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection

/** Scrolls by touch or wheel. */
@Composable
internal fun Modifier.scrolls(view: EditorView): Modifier {
    val down = rememberScrollableState { -view.scrollDown(-it) }
    return scrollable(down, Orientation.Vertical)
}

@Composable
internal fun rememberTouch(
    control: EditorControl,
    layouts: LineLayouts,
    pieces: CodeTokens,
    draft: TextDocument,
    focus: FocusRequester,
    actions: EditorActions,
): EditorTouch {
    val view = control.view
    val keyboard = LocalSoftwareKeyboardController.current
    val now by rememberUpdatedState(Triple(draft, layouts, pieces))
    val act by rememberUpdatedState(actions)
    return remember(control, view) {
        object : EditorTouch {
            override fun pressed(byFinger: Boolean) {
                control.isPressedByFinger = byFinger
                control.hadFocus = control.hasFocus
            }

            override fun tapped(position: Offset, times: Int, selecting: Boolean, byFinger: Boolean) {
                val line = view.geometry.lineAt(position.y + view.scrollY) + 1
                if (position.x < view.gutter - GUTTER_EDGE) {
                    act.toggleBreakpoint(line)
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

            override fun zoomed(factor: Float) = act.zoom(factor)

            private fun offsetAt(position: Offset) = now.let { (text, lines, parts) ->
                view.offsetAt(position, text, lines, parts)
            }
        }
    }
}

/** The pixels left of the text that still count as text. */
private const val GUTTER_EDGE = 4f
