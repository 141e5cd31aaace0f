package robotran.ui.sheet

import androidx.compose.ui.graphics.PixelMap
import androidx.compose.ui.graphics.luminance
import androidx.compose.ui.graphics.toPixelMap
import robotran.uikit.*
import robotran.world.Template
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertTrue

class TemplatePictureTest {
    @Test
    fun `a drawing to be traced can be seen in a picture of any size, by day and by night`() {
        val paper = BuiltInWorlds.plain.paper
        val line = listOf(Point(paper.width * 0.1, paper.height * 0.2), Point(paper.width * 0.9, paper.height * 0.2))
        val world = BuiltInWorlds.plain.copy(template = Template(listOf(line)))
        for (width in listOf(100, 160, 280, 560, 1_200)) {
            for (colours in listOf(SheetColours.LIGHT, SheetColours.of(RobotranColours.DARK))) {
                val picture = renderSheet(world, SheetScenes.state(world), width, colours = colours).toPixelMap()
                val contrasts = (0..<picture.height).map { y -> picture.bestContrast(y, colours.paper.luminance()) }
                    .subList((picture.height * 0.7).toInt(), (picture.height * 0.88).toInt())
                val described = "$width pixels wide on ${colours.paper}: ${contrasts.filter { it > 1.1f }}"
                assertTrue(contrasts.max() >= MIN_CONTRAST, described)
                assertTrue(contrasts.count { it >= MIN_CONTRAST / 2 } >= 2, described)
            }
        }
    }

    /** The max contrast (WCAG 2.2) of the row [y] with the paper, without the edges of the paper. */
    private fun PixelMap.bestContrast(y: Int, paper: Float): Float =
        (width / 5..width * 4 / 5).maxOf { x -> (paper + GLARE) / (this[x, y].luminance() + GLARE) }

    private companion object {
        const val GLARE = 0.05f

        /** Symbols need 3; anti-aliasing reduces the contrast of the smallest dots. */
        const val MIN_CONTRAST = 2.6f
    }
}
