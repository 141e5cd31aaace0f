package robotran.ui.sheet

import androidx.compose.ui.graphics.ImageBitmap
import robotran.ui.pictures.pngOf
import robotran.ui.pictures.sheetPng
import robotran.uikit.*
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import java.io.File
import javax.imageio.ImageIO
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Pictures for review, in `build/pictures`. */
class SheetGalleryTest {
    private val pictures = File("build/pictures").apply { mkdirs() }

    @Test
    fun `everything is drawn large and small, by day and by night`() {
        val night = SheetColours.of(RobotranColours.DARK)
        for ((name, width, colours) in listOf(
            Triple("everything", 1600, SheetColours.LIGHT),
            Triple("everything-night", 1600, night),
            Triple("everything-small", 360, night),
        )) {
            val file = pictures.resolve("$name.png")
            file.writeBytes(sheetPng(SheetScenes.everything, SheetScenes.everythingLater, width, colours))
            assertEquals(width, ImageIO.read(file).width)
        }
    }

    @Test
    fun `the ways of several runs can be told apart`() {
        val runs = (0 until 20).map { run ->
            val far = 60.0 + run
            RobotTrack(
                listOf(Point(20.0, 20.0), Point(far, 20.0 + run), Point(far - 5, 70.0)),
                Pose(far - 5, 70.0, 100.0),
            )
        }
        val picture = renderRuns(SheetScenes.everything, runs)
        pictures.resolve("runs.png").writeBytes(pngOf(picture))
        val colours = (0 until 20).map { run -> picture.colourAt(60.0 + run - 2.5, 45.0 + run / 2.0) }
        assertTrue(colours.toSet().size > 10)
    }

    private fun ImageBitmap.colourAt(x: Double, y: Double): Int {
        val scale = width / 124.0
        val pixel = IntArray(1)
        readPixels(pixel, ((x + 2) * scale).toInt(), ((92 - y) * scale).toInt(), 1, 1)
        return pixel.single()
    }
}
