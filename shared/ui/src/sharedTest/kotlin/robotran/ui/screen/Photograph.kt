package robotran.ui.screen

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.input.InputMode
import androidx.compose.ui.platform.LocalInputModeManager
import androidx.compose.ui.unit.Density
import org.jetbrains.skia.Bitmap
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Image
import org.jetbrains.skiko.MainUIDispatcher
import robotran.ui.RobotranApp
import robotran.workshop.Workshop
import java.io.File
import kotlin.test.assertTrue

/**
 * A screenshot of [workshop] on a screen of [width] by [height] once nothing moves; [meanwhile] runs on the screen
 * before.
 */
internal fun photograph(
    workshop: Workshop,
    width: Int,
    height: Int,
    dark: Boolean = false,
    isRightToLeft: Boolean = false,
    meanwhile: (ImageComposeScene) -> Unit = {},
): Image = onEventThread {
    val scene = sceneOf(width, height) { Undrawn { RobotranApp(workshop, dark, isRightToLeft = isRightToLeft) } }
    try {
        scene.render()
        scene.render(nanoTime = SECOND)
        meanwhile(scene)
        drawn { scene.render(nanoTime = REST) }
    } finally {
        scene.close()
    }
}

/**
 * A screen of [width] by [height] pixels for the event thread that shows [content].
 *
 * Its effects stay on the event thread. Without a dispatcher, an effect that has waited goes on in a thread of the
 * timer, changes the screen while the event thread draws it, and fails in whatever test runs next.
 */
internal fun sceneOf(width: Int, height: Int, content: @Composable () -> Unit): ImageComposeScene =
    ImageComposeScene(width, height, Density(1f), coroutineContext = MainUIDispatcher) {
        AfterTouch()
        content()
    }

/**
 * Makes touches the input in use. All scenes share it, so without this a ring in a picture would depend on whether the
 * test before has ended with a key.
 */
@OptIn(ExperimentalComposeUiApi::class)
@Composable
private fun AfterTouch() {
    val manager = LocalInputModeManager.current
    remember(manager) { manager.requestInputMode(InputMode.Touch) }
}

/** Saves the picture as [name].png in build/pictures for review. Fails for a nearly empty screen. */
internal fun Image.keepAs(name: String) {
    val file = File(System.getProperty("robotran.pictures"), "$name.png").apply { parentFile.mkdirs() }
    file.writeBytes(checkNotNull(encodeToData(EncodedImageFormat.PNG)).bytes)
    val bitmap = Bitmap.makeFromImage(this)
    val colours = (0..<width step SAMPLE).flatMap { x ->
        (0..<height step SAMPLE).map { y -> bitmap.getColor(x, y) }
    }.toSet()
    assertTrue(colours.size > FEW_COLOURS, "$name is next to empty: ${colours.size} colours")
}

private const val SECOND = 1_000_000_000L

/** Longer than any action on a screen takes. */
private const val REST = 60 * SECOND

/** The distance in pixels between samples. */
private const val SAMPLE = 5
private const val FEW_COLOURS = 8
