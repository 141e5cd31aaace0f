package robotran.desktop

import robotran.cli.CommandLine
import robotran.console.ProcessConsole
import java.io.File
import java.nio.file.Files
import javax.imageio.ImageIO
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Tests the pictures that `robotran run --picture` writes with this app. */
class PictureTest {
    private val folder = Files.createTempDirectory("robotran")
    private val square = File(System.getProperty("robotran.tree")).resolve("examples/square.robo").path

    @AfterTest
    fun tidyUp() {
        folder.toFile().deleteRecursively()
    }

    private fun run(vararg arguments: String) =
        CommandLine(ProcessConsole, ComposeApp).execute(listOf("run") + arguments)

    @Test
    fun `a picture whose name ends in svg holds the ink as lines`() {
        val picture = folder.resolve("square.SVG")
        assertEquals(0, run(square, "--picture", "$picture"))
        val text = picture.toFile().readText()
        assertTrue(text.startsWith("<svg xmlns=") && text.trimEnd().endsWith("</svg>"), text.take(100))
        assertTrue("<polyline points=\"40,50 " in text, text)
    }

    @Test
    fun `the picture shows ink where the robot drew and none where it did not`() {
        val picture = folder.resolve("square.png")
        assertEquals(0, run(square, "--picture", "$picture"))
        val image = ImageIO.read(picture.toFile())
        // The paper is 100 cm wide, with 2 cm of desk around it. The square's sides are at x = 40 and 60 cm, y = 30 and
        // 50 cm.
        val pixelsPerCentimetre = image.width / 104.0

        fun isInk(x: Double, y: Double): Boolean {
            val column = ((x + 2) * pixelsPerCentimetre).toInt()
            val row = (image.height - (y + 2) * pixelsPerCentimetre).toInt()
            return (-3..3).any { step ->
                listOf(image.getRGB(column + step, row), image.getRGB(column, row + step)).any {
                    it and 0xFF > 2 * (it shr 16 and 0xFF)
                }
            }
        }
        for ((x, y) in listOf(
            55.0 to 30.0,
            60.0 to 40.0,
            50.0 to 50.0,
            40.0 to 45.0,
        )) {
            assertTrue(isInk(x, y), "ink at $x, $y")
        }
        for ((x, y) in listOf(50.0 to 40.0, 20.0 to 60.0, 80.0 to 40.0)) assertFalse(isInk(x, y), "no ink at $x, $y")
    }
}
