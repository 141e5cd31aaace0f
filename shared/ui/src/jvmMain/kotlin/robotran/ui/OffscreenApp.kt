package robotran.ui

import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.InternalComposeUiApi
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.unit.Density
import robotran.ui.workshop.Workshop

/**
 * The app on no screen, [width] by [height] pixels large, drawn in software whenever [frame] says so: for measuring it. To be closed; the
 * [workshop] is not closed with it.
 */
class OffscreenApp(workshop: Workshop, width: Int, height: Int, dark: Boolean = false) : AutoCloseable {
    private val scene = ImageComposeScene(width, height, Density(1f)) { RobotranApp(workshop, dark) }
    private var now = 0L

    /** Draws the next picture, [milliseconds] after the one before. */
    fun frame(milliseconds: Int = USUAL_FRAME) {
        now += milliseconds * NANOSECONDS
        scene.render(now).close()
    }

    /** Presses [key] and lets it go. */
    @OptIn(InternalComposeUiApi::class)
    fun press(key: Key) {
        scene.sendKeyEvent(KeyEvent(key, KeyEventType.KeyDown))
        scene.sendKeyEvent(KeyEvent(key, KeyEventType.KeyUp))
    }

    override fun close() = scene.close()

    private companion object {
        const val USUAL_FRAME = 16
        const val NANOSECONDS = 1_000_000L
    }
}
