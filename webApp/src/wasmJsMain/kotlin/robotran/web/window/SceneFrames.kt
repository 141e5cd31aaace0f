package robotran.web.window

import androidx.compose.ui.InternalComposeUiApi
import androidx.compose.ui.graphics.asComposeCanvas
import androidx.compose.ui.scene.ComposeScene
import org.jetbrains.skia.Canvas
import org.jetbrains.skia.Surface
import org.jetbrains.skiko.SkikoRenderDelegate

/**
 * Draws the pictures of [scene]. What a key or a finger changes (a text, what is selected, what has the focus) holds
 * only from the next picture on. Where fingers are quicker than pictures, the next key would be taken by what was there
 * before, and what the last one wrote would be lost; so [catchUp] makes the picture at once.
 */
@OptIn(InternalComposeUiApi::class)
internal class SceneFrames(private val scene: ComposeScene) : SkikoRenderDelegate {
    /** Kept itself, since its canvas is gone with it. */
    private val nowhere by lazy { Surface.makeNull(1, 1) }
    private var time = 0L
    private var isBehind = false

    override fun onRender(canvas: Canvas, width: Int, height: Int, nanoTime: Long) {
        isBehind = false
        time = nanoTime
        scene.render(canvas.asComposeCanvas(), nanoTime)
    }

    /** Something has happened that the next picture makes true. */
    fun fallBehind() {
        isBehind = true
    }

    /**
     * Makes true what has happened since the last picture, in a picture that nobody sees; the next one is drawn as if
     * this had not been.
     */
    fun catchUp() {
        if (!isBehind) return
        isBehind = false
        scene.render(nowhere.canvas.asComposeCanvas(), time)
    }
}
