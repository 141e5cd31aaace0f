package robotran.desktop.platform

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.programs.Program
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.ui.poster.DrawnPoster
import robotran.workshop.state.Poster
import robotran.world.file.BuiltInWorlds
import java.awt.image.BufferedImage
import java.awt.print.PageFormat
import java.awt.print.Printable
import java.io.File
import javax.imageio.ImageIO
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class PosterPrintableTest {
    private val drawn = DrawnPoster(posterOf("pen down\nforward 20"))

    @Test
    fun `the page is A4 without margins, and upright for a short program`() {
        val format = pageFormatFor(drawn)
        assertEquals(PageFormat.PORTRAIT, format.orientation)
        assertEquals(595.28, format.width, 0.01)
        assertEquals(841.89, format.imageableHeight, 0.01)
    }

    @Test
    fun `there is one page, with title, drawing and program on it`() {
        val page = BufferedImage(595, 842, BufferedImage.TYPE_INT_RGB)
        val printable = PosterPrintable(drawn)
        assertEquals(Printable.PAGE_EXISTS, printable.print(page.graphics, pageFormatFor(drawn), 0))
        assertEquals(Printable.NO_SUCH_PAGE, printable.print(page.graphics, pageFormatFor(drawn), 1))
        File("build/pictures").mkdirs()
        ImageIO.write(page, "png", File("build/pictures/printed-poster.png"))
        assertTrue(page.darkPixels(20..60) > 100, "the title")
        assertTrue(page.darkPixels(100..400) > 500, "the robot")
        assertTrue(page.darkPixels(480..600) > 100, "the program")
        assertEquals(0, page.darkPixels(790..841), "nothing below")
    }

    private fun BufferedImage.darkPixels(rows: IntRange) =
        rows.sumOf { y -> (0..<width).count { x -> getRGB(x, y) and 0xFF00 < 0x7000 } }

    private fun posterOf(text: String): Poster {
        val session =
            Session(
                BuiltInWorlds.plain,
                emptyList<RobotProgramSet>(),
                runBlocking {
                    loadPhysicsEngine()
                },
                Language.ENGLISH,
            )
        val state = session.state
        session.close()
        val program = Program.of("line.robo", text)
        return Poster("A line", "Ada", "", BuiltInWorlds.plain, state, program, Language.ENGLISH)
    }
}
