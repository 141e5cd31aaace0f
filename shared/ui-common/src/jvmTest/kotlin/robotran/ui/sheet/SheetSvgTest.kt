package robotran.ui.sheet

import androidx.compose.ui.graphics.Color
import org.jetbrains.skia.Data
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Surface
import org.jetbrains.skia.svg.SVGDOM
import org.w3c.dom.Document
import org.w3c.dom.Element
import org.xml.sax.InputSource
import robotran.ui.pictures.worldPictureSvg
import robotran.ui.sheet.svg.figure
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
        assertEquals(2, document.elements("line").count { it.getAttribute("stroke") == "url(#hatching)" })
        assertEquals("-2 -2 124 94", document.documentElement.getAttribute("viewBox"))
        assertEquals(listOf("1", "2", "yellow", "red"), document.elements("text").map { it.textContent })
    }

    @Test
    fun `the drawing looks like the picture of pixels`() {
        val data = Data.makeFromBytes(svg.encodeToByteArray())
        val surface = Surface.makeRasterN32Premul(WIDTH, WIDTH * 94 / 124)
        SVGDOM(data).apply {
            setContainerSize(surface.width.toFloat(), surface.height.toFloat())
        }.render(surface.canvas)
        val image = surface.makeImageSnapshot()
        File("build/pictures").mkdirs()
        File(
            "build/pictures/everything-svg.png",
        ).writeBytes(checkNotNull(image.encodeToData(EncodedImageFormat.PNG)).bytes)
        val pixels = org.jetbrains.skia.Bitmap.makeFromImage(image)

        fun at(x: Double, y: Double) =
            Color(pixels.getColor(((x + 2) * WIDTH / 124).toInt(), ((92 - y) * WIDTH / 124).toInt()))
        val besideInk = (-3..3).minOf { difference(SheetColours.INK, at(5.0 + it * 0.1, 15.0)) }
        assertTrue(besideInk < 0.1, "There is no ink: $besideInk")
        // In the glow of the robot's own lamp.
        assertTrue(difference(RobotColours.ink(1, SheetScenes.everything.robots), at(105.0, 56.0)) < 0.15)
        assertNear(SheetColours.LIGHT.desk, at(-1.0, 40.0))
        assertNear(SheetColours.LIGHT.paper, at(106.0, 12.5))
        assertNear(Color(0x80, 0x80, 0x80), at(98.0, 22.0))
    }

    @Test
    fun `figures have no more decimals than they need`() {
        val numbers = listOf(0.0, 12.0, -0.5, 3.14159, -0.0001, -1000.0011)
        assertEquals(listOf("0", "12", "-0.5", "3.142", "0", "-1000.001"), numbers.map(::figure))
    }

    private fun assertNear(expected: Color, colour: Color) {
        assertTrue(difference(expected, colour) < 0.08, "$colour is not $expected")
    }

    private fun difference(expected: Color, colour: Color): Float =
        maxOf(abs(expected.red - colour.red), abs(expected.green - colour.green), abs(expected.blue - colour.blue))

    private fun read(text: String): Document =
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(InputSource(StringReader(text)))

    private fun Document.elements(name: String): List<Element> =
        getElementsByTagName(name).let { list -> List(list.length) { list.item(it) as Element } }

    private companion object {
        const val WIDTH = 1200
    }
}
