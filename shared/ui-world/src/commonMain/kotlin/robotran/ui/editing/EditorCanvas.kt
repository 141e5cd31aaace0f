package robotran.ui.editing

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.boundsInRoot
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import robotran.uikit.*

/**
 * Where an editor shows what is edited.
 *
 * @property tag for tests.
 * @property name what a screen reader calls it.
 * @property chosen what is chosen; screen readers announce it.
 * @property hasRingInside whether the ring of the focus is inside.
 */
internal class CanvasWords(val tag: String, val name: String, val chosen: String, val hasRingInside: Boolean)

/**
 * A canvas with touch and keyboard input, which takes the focus.
 *
 * @param onKey the edit for a key.
 * @param follow follows a finger from where it is pressed, with the latest scope.
 */
@Composable
internal fun <T : Any, S : EditScope<T>> EditorCanvas(
    words: CanvasWords,
    scope: S,
    view: EditorView,
    focus: FocusRequester,
    onKey: (KeyEvent) -> T?,
    follow: suspend AwaitPointerEventScope.(() -> S, Offset) -> Unit,
    draw: DrawScope.() -> Unit,
) {
    val latest = rememberUpdatedState(scope)
    val key = rememberUpdatedState(onKey)
    Canvas(
        Modifier
            .fillMaxSize()
            .testTag(words.tag)
            .focusRing(isInside = words.hasRingInside)
            .onGloballyPositioned { view.window = it.boundsInRoot() }
            .semantics {
                contentDescription = words.name
                stateDescription = words.chosen
                liveRegion = LiveRegionMode.Polite
            }
            .focusRequester(focus)
            .onKeyEvent { event -> key.value(event)?.let { latest.value.make(it) } != null }
            .focusable()
            .pointerInput(view) { editByTouch({ focus.requestFocus() }) { follow({ latest.value }, it) } }
            .pointerInput(view) { zoomByWheel(view) }
            .clipToBounds(),
    ) { if (!view.window.isEmpty) draw() }
    LaunchedEffect(focus) { focus.requestFocus() }
}
