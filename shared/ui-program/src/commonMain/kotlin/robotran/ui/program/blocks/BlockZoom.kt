package robotran.ui.program.blocks

import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.pointerInput
import robotran.ui.program.editor.EditorTouch
import robotran.ui.program.editor.listenForZoom

/** Two fingers, or Ctrl and the mouse wheel, scale the text by the factor that [onZoom] receives. */
@Composable
internal fun Modifier.zoomsBlocks(onZoom: (Float) -> Unit): Modifier {
    val zoom by rememberUpdatedState(onZoom)
    val touch = remember {
        object : EditorTouch {
            override fun tapped(position: Offset, times: Int, selecting: Boolean, byFinger: Boolean) = Unit

            override fun longPressed(position: Offset) = Unit

            override fun draggedTo(position: Offset) = Unit

            override fun zoomed(factor: Float) = zoom(factor)
        }
    }
    return pointerInput(touch) { listenForZoom(touch) }
}
