package robotran.ui.screen

import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawWithContent
import androidx.compose.ui.graphics.PixelMap
import androidx.compose.ui.graphics.toPixelMap
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.captureToImage
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.runDesktopComposeUiTest
import org.jetbrains.skia.Canvas
import org.jetbrains.skia.Rect
import org.jetbrains.skia.Surface

/** Whether the current test takes a picture. Tests run one after the other. */
private var isDrawn by mutableStateOf(false)

/** The canvas of the current [undrawnTest], clipped to nothing. */
private var hidden: Canvas? = null

/**
 * A test of a screen of this size whose frames are composed and laid out, but drawn only in [drawn]. [Undrawn] would not
 * keep dialogs and menus from being drawn, since these have layers of their own, each with a veil over the whole screen.
 */
@OptIn(ExperimentalTestApi::class)
internal fun undrawnTest(width: Int, height: Int, check: ComposeUiTest.() -> Unit) = onEventThread {
    runDesktopComposeUiTest(width, height) {
        val canvas = canvasOf(this)
        try {
            canvas.hide()
            hidden = canvas
            check()
        } finally {
            hidden = null
        }
    }
}

/** Compose's test has it for itself alone. */
@OptIn(ExperimentalTestApi::class)
private fun canvasOf(test: ComposeUiTest): Canvas {
    val surface = test.javaClass.getDeclaredField("surface").apply { isAccessible = true }
    return (surface.get(test) as Surface).canvas
}

private fun Canvas.hide() {
    save()
    clipRect(Rect.makeWH(0f, 0f))
}

/** Composes and lays out [content], but draws it only while a test takes a picture. */
@Composable
internal fun Undrawn(content: @Composable () -> Unit) =
    Box(Modifier.drawWithContent { if (isDrawn) drawContent() }) { content() }

/** The pixels of the element [tag] in a frame that is drawn for this. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.pixelsOf(tag: String): PixelMap = drawn {
    pass(1)
    onNodeWithTag(tag).captureToImage().toPixelMap()
}

/** Draws the frames that [render] renders. */
internal fun <T> drawn(render: () -> T): T {
    isDrawn = true
    hidden?.restore()
    try {
        return render()
    } finally {
        hidden?.hide()
        isDrawn = false
    }
}
