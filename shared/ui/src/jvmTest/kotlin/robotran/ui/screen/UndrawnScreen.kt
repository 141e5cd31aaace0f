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
import robotran.ui.RobotranApp
import robotran.workshop.Workshop

/** Whether somebody looks at the screen of the current test. */
private var isDrawn by mutableStateOf(false)

/**
 * Shows [workshop] on a screen of this size in dp, with a manual clock, and runs [check].
 *
 * A test renders a frame before each look at the tree. Drawing it in software would take most of the test's time, and
 * only a picture shows it, so frames are composed and laid out, but drawn for [pixelsOf] only.
 */
@OptIn(ExperimentalTestApi::class)
internal fun onScreenOf(
    workshop: Workshop,
    width: Int,
    height: Int,
    embedded: Boolean = false,
    check: ComposeUiTest.() -> Unit,
) {
    try {
        runDesktopComposeUiTest(width, height) {
            mainClock.autoAdvance = false
            setContent { Undrawn { RobotranApp(workshop, dark = false, embedded = embedded) } }
            pass(SETTLE_MILLIS)
            check()
        }
    } finally {
        workshop.close()
    }
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

/** Frames that [look] renders are drawn. */
internal fun <T> drawn(look: () -> T): T {
    isDrawn = true
    try {
        return look()
    } finally {
        isDrawn = false
    }
}

private const val SETTLE_MILLIS = 100L
