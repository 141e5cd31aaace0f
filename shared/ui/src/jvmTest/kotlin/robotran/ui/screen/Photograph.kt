package robotran.ui.screen

import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.unit.Density
import org.jetbrains.skia.Bitmap
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Image
import robotran.ui.RobotranApp
import robotran.workshop.Workshop
import java.io.File
import kotlin.test.assertTrue

/**
 * How [workshop] looks on a screen of [width] by [height] once all has come to rest; before that, [meanwhile] is done
 * to the screen.
 */
internal fun photograph(
    workshop: Workshop,
    width: Int,
    height: Int,
    dark: Boolean = false,
    meanwhile: (ImageComposeScene) -> Unit = {},
): Image = onEventThread {
    val scene = ImageComposeScene(width, height, Density(1f)) { RobotranApp(workshop, dark) }
    try {
        scene.render()
        scene.render(nanoTime = SECOND)
        meanwhile(scene)
        scene.render(nanoTime = REST)
    } finally {
        scene.close()
    }
}

/**
 * Keeps the picture as [name].png in build/pictures, to be looked at. A screen that shows next to nothing is a fault.
 */
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

/** Whatever is done to a screen in between takes less than this. */
private const val REST = 60 * SECOND

/** Pixels between those that are looked at. */
private const val SAMPLE = 5
private const val FEW_COLOURS = 8
