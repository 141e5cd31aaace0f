package robotran.desktop.window

import androidx.compose.ui.Alignment
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import androidx.compose.ui.window.WindowPlacement
import androidx.compose.ui.window.WindowPosition
import androidx.compose.ui.window.WindowState
import java.awt.GraphicsEnvironment
import java.awt.Rectangle

/**
 * The bounds of a window as one line of text: left, top, width and height in screen units, and whether it was
 * maximised.
 */
internal data class WindowBounds(
    val left: Int,
    val top: Int,
    val width: Int,
    val height: Int,
    val isMaximised: Boolean,
) {
    fun toText(): String = "$left $top $width $height $isMaximised"

    companion object {
        /** Parses [text]; null if it is invalid. */
        fun of(text: String): WindowBounds? {
            val words = text.trim().split(' ')
            val numbers = words.take(4).mapNotNull { it.toIntOrNull() }
            if (words.size != 5 || numbers.size != 4) return null
            return WindowBounds(numbers[0], numbers[1], numbers[2], numbers[3], words[4] == "true")
        }

        /** Null while the window has no position yet. */
        fun of(state: WindowState): WindowBounds? {
            val position = state.position as? WindowPosition.Absolute ?: return null
            return WindowBounds(
                position.x.value.toInt(),
                position.y.value.toInt(),
                state.size.width.value.toInt(),
                state.size.height.value.toInt(),
                state.placement == WindowPlacement.Maximized,
            )
        }
    }
}

/** The initial window state: the last bounds if they are still on a screen and free, otherwise centred. */
internal fun windowStateFor(last: WindowBounds?, screens: List<Rectangle> = screens()): WindowState {
    val width = last?.width?.coerceAtLeast(MIN_WIDTH) ?: 0
    if (last == null ||
        screens.none { it.intersection(Rectangle(last.left, last.top, width, TITLE_HEIGHT)).width >= GRIP }
    ) {
        return WindowState(position = WindowPosition(Alignment.Center), size = firstSize())
    }
    return WindowState(
        placement = if (last.isMaximised) WindowPlacement.Maximized else WindowPlacement.Floating,
        position = WindowPosition.Absolute(last.left.dp, last.top.dp),
        size = DpSize(width.dp, last.height.coerceAtLeast(MIN_HEIGHT).dp),
    )
}

/** The size of a laptop window, but at most the free area of the screen. */
private fun firstSize(): DpSize {
    val screen = GraphicsEnvironment.getLocalGraphicsEnvironment().maximumWindowBounds
    return DpSize(minOf(1280, screen.width).dp, minOf(840, screen.height).dp)
}

private fun screens(): List<Rectangle> =
    GraphicsEnvironment.getLocalGraphicsEnvironment().screenDevices.map { it.defaultConfiguration.bounds }

/** At this size the UI uses its phone layout. */
internal const val MIN_WIDTH = 360
internal const val MIN_HEIGHT = 560

/** The part of the title bar that must be on a screen, so that the user can move the window. */
private const val GRIP = 100
private const val TITLE_HEIGHT = 30
