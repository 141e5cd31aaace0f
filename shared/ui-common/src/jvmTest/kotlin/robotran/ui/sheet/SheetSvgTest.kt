package robotran.ui.sheet

import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.PixelMap
import androidx.compose.ui.graphics.asComposeImageBitmap
import androidx.compose.ui.graphics.toPixelMap
import org.jetbrains.skia.Bitmap
import org.jetbrains.skia.Data
import org.jetbrains.skia.Surface
import org.jetbrains.skia.svg.SVGDOM
import org.w3c.dom.Document
import org.w3c.dom.Element
import org.xml.sax.InputSource
import robotran.ui.pictures.pngOf
import robotran.ui.pictures.worldPictureSvg
import robotran.ui.sheet.svg.figure
import robotran.ui.sheet.svg.hex
import java.io.File
import java.io.StringReader
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class SheetSvgTest {
    private val svg = worldPictureSvg(SheetScenes.everything, SheetScenes.everythingLater)

    @Test
    fun `the picture is XML with the world's title and task, whatever is written there`() {
        val world = SheetScenes.everything.copy(
            title = "<Tom> & \"Ann\" \u0007\uD83E end 🤖",
            task = "Drive ]]> away.\nThen stop.",
        )
        val document = read(worldPictureSvg(world, SheetScenes.everythingLater))
        assertEquals("<Tom> & \"Ann\"  \uFFFD end 🤖", document.getElementsByTagName("title").item(0).textContent)
        assertEquals("Drive ]]> away.\nThen stop.", document.getElementsByTagName("desc").item(0).textContent)
    }

    @Test
    fun `everything is in it as what it is`() {
        val document = read(svg)
        val lines = document.elements("polyline").filter { it.getAttribute("stroke-width") == "0.3" }
        assertTrue("5,85 5,65 24,68" in lines.map { it.getAttribute("points") })
        assertEquals(1, document.elements("path").count { it.getAttribute("fill") == hex(SheetColours.WALL) })
        assertEquals(
            6,
            document.elements("polygon", "circle", "rect").count {
                it.getAttribute("fill") ==
                    hex(SheetColours.LAMP) ||
                    it.getAttribute("fill") == hex(SheetColours.BLOCK)
            },
        )
        assertEquals("-2 -2 124 94", document.documentElement.getAttribute("viewBox"))
        assertEquals(listOf("1", "2", "yellow", "red"), document.elements("text").map { it.textContent })
    }

    @Test
    fun `the drawing looks like the picture of pixels`() {
        // Numbers stand beside flags, and not all that draw SVG have fonts.
        val world = SheetScenes.everything.copy(goals = SheetScenes.everything.goals.drop(1))
        val state = SheetScenes.everythingLater.copy(goals = emptyList())
        val withoutShadows = SheetColours.LIGHT.copy(shadow = Color.Transparent)
        val expected = renderSheet(world, state, WIDTH, colours = withoutShadows).toPixelMap()
        val seen = rendered(worldPictureSvg(world, state), expected.width, expected.height)
        File("build/pictures").mkdirs()
        File("build/pictures/everything-svg.png").writeBytes(pngOf(seen))
        val pixels = seen.toPixelMap()
        // Dots and hatching have the same distances, but other places: in the mean of a cell they are the same.
        for (top in 0..<expected.height - CELL step CELL) {
            for (left in 0..<expected.width - CELL step CELL) {
                val (one, other) = listOf(expected, pixels).map { mean(it, left, top) }
                assertTrue(difference(one, other) < CLEARLY, "$one and $other at $left, $top")
            }
        }
    }

    @Test
    fun `figures have no more decimals than they need`() {
        val numbers = listOf(0.0, 12.0, -0.5, 3.14159, -0.0001, -1000.0011)
        assertEquals(listOf("0", "12", "-0.5", "3.142", "0", "-1000.001"), numbers.map(::figure))
    }

    private fun rendered(svg: String, width: Int, height: Int): ImageBitmap {
        val surface = Surface.makeRasterN32Premul(width, height)
        SVGDOM(Data.makeFromBytes(svg.encodeToByteArray())).apply {
            setContainerSize(width.toFloat(), height.toFloat())
        }.render(surface.canvas)
        return Bitmap.makeFromImage(surface.makeImageSnapshot()).asComposeImageBitmap()
    }

    private fun mean(pixels: PixelMap, left: Int, top: Int): Color {
        val colours = (0..<CELL * CELL).map { pixels[left + it % CELL, top + it / CELL] }

        fun mean(part: (Color) -> Float) = colours.map(part).average().toFloat()
        return Color(mean { it.red }, mean { it.green }, mean { it.blue })
    }

    private fun difference(expected: Color, colour: Color): Float =
        maxOf(abs(expected.red - colour.red), abs(expected.green - colour.green), abs(expected.blue - colour.blue))

    private fun read(text: String): Document =
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(InputSource(StringReader(text)))

    private fun Document.elements(vararg names: String): List<Element> = names.flatMap { name ->
        getElementsByTagName(name).let { list -> List(list.length) { list.item(it) as Element } }
    }

    private companion object {
        const val WIDTH = 1200
        const val CLEARLY = 0.1f
        const val CELL = 25
    }
}
