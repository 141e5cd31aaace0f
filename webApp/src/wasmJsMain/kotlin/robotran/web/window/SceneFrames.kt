package robotran.web.window

import androidx.compose.ui.InternalComposeUiApi
import androidx.compose.ui.graphics.asComposeCanvas
import androidx.compose.ui.scene.ComposeScene
import org.jetbrains.skia.Canvas
import org.jetbrains.skia.Surface
import org.jetbrains.skiko.SkikoRenderDelegate

/**
 * Renders the frames of [scene]. Changes by a key or touch (text, selection, focus) take effect with the next frame. If
 * input is faster than frames, the next key would go to the old state and the previous one would be lost. [catchUp]
 * therefore renders a frame at once.
 */
@OptIn(InternalComposeUiApi::class)
internal class SceneFrames(private val scene: ComposeScene) : SkikoRenderDelegate {
    /** A property, since its canvas is destroyed with it. */
    private val nowhere by lazy { Surface.makeNull(1, 1) }
    private var time = 0L
    private var isPending = false

    override fun onRender(canvas: Canvas, width: Int, height: Int, nanoTime: Long) {
        isPending = false
        time = nanoTime
        scene.render(canvas.asComposeCanvas(), nanoTime)
    }

    /** Marks that input is waiting for the next frame. */
    fun markPending() {
        isPending = true
    }

    /** Applies pending input by rendering a frame off screen. Does not affect the next visible frame. */
    fun catchUp() {
        if (!isPending) return
        isPending = false
        scene.render(nowhere.canvas.asComposeCanvas(), time)
    }
}
