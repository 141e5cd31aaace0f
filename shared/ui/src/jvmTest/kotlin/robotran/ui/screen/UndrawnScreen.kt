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

/** Whether the current test takes a picture. Tests run one after the other. */
private var isDrawn by mutableStateOf(false)

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
    try {
        return render()
    } finally {
        isDrawn = false
    }
}
