package robotran.animatedpicture

import io.kotest.common.ExperimentalKotest
import io.kotest.property.Arb
import io.kotest.property.PropTestConfig
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import kotlinx.coroutines.runBlocking
import java.awt.image.BufferedImage
import java.io.ByteArrayInputStream
import javax.imageio.ImageIO
import javax.imageio.metadata.IIOMetadataNode
import kotlin.math.abs
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Reads the files with another reader, as a viewer does. */
@OptIn(ExperimentalKotest::class)
class ReadGifTest {
    @Test
    fun `any frames of few colours come back pixel by pixel`() = runBlocking<Unit> {
        checkAll(PropTestConfig(seed = 20), Arb.int(1..64), Arb.int(1..64), Arb.int(1..255), Arb.long()) {
            width,
            height,
            colours,
            seed,
            ->
            val random = Random(seed)
            // Close to each other, as the steps of a glow are.
            val palette = IntArray(colours) { it * 65_793 / 2 }
            val frames = randomFrames(random, width, height, palette)
            val read = read(gifOf(TestFrames(width, frames)))
            val shown = frames.filterIndexed { index, frame -> index == 0 || !frame.contentEquals(frames[index - 1]) }
            assertEquals(shown.map { it.toList() }, read.map { it.pixels.toList() })
            assertEquals(frames.size * 8 + 200, read.sumOf { it.delay })
        }
    }

    @Test
    fun `frames of many colours come back with similar colours`() = runBlocking<Unit> {
        checkAll(PropTestConfig(iterations = 30, seed = 21), Arb.int(20..80), Arb.long()) { width, seed ->
            val random = Random(seed)
            val tint = random.nextInt(200)
            val glow = IntArray(width * width) { place ->
                val red = 255 * (place % width) / width
                val green = 255 * (place / width) / width
                (red shl 16) or (green shl 8) or tint
            }
            val read = read(gifOf(TestFrames(width, listOf(glow)))).single().pixels
            val worst = glow.zip(read).maxOf { (drawn, shown) ->
                maxOf(abs(red(drawn) - red(shown)), abs(green(drawn) - green(shown)), abs(blue(drawn) - blue(shown)))
            }
            assertTrue(worst <= 24, "$worst")
        }
    }

    @Test
    fun `long lines of codes fill the table and start anew`() {
        val random = Random(5)
        val palette = IntArray(250) { it * 1_000 }
        val noise = IntArray(300 * 300) { palette[random.nextInt(250)] }
        val stripes = IntArray(300 * 300) { palette[it / 7 % 250] }
        val read = read(gifOf(TestFrames(300, listOf(noise, stripes, noise))))
        assertEquals(listOf(noise, stripes, noise).map { it.toList() }, read.map { it.pixels.toList() })
    }

    private fun randomFrames(random: Random, width: Int, height: Int, palette: IntArray): List<IntArray> {
        val frames = mutableListOf(IntArray(width * height) { palette[random.nextInt(palette.size)] })
        repeat(random.nextInt(6)) {
            val next = frames.last().copyOf()
            repeat(random.nextInt(width * height / 2 + 1)) {
                next[random.nextInt(next.size)] = palette[random.nextInt(palette.size)]
            }
            frames += next
        }
        return frames
    }

    /** All frames as a viewer shows them, one drawn over the other. */
    private fun read(bytes: ByteArray): List<ShownFrame> {
        val reader = ImageIO.getImageReadersByFormatName("gif").next()
        reader.input = ImageIO.createImageInputStream(ByteArrayInputStream(bytes))
        var canvas: BufferedImage? = null
        return List(reader.getNumImages(true)) { index ->
            val part = reader.read(index)
            val tree = reader.getImageMetadata(index).getAsTree("javax_imageio_gif_image_1.0") as IIOMetadataNode
            val place = tree.getElementsByTagName("ImageDescriptor").item(0) as IIOMetadataNode
            val control = tree.getElementsByTagName("GraphicControlExtension").item(0) as IIOMetadataNode
            val whole = canvas ?: BufferedImage(part.width, part.height, BufferedImage.TYPE_INT_ARGB)
            canvas = whole
            whole.createGraphics().drawImage(
                part,
                place.getAttribute("imageLeftPosition").toInt(),
                place.getAttribute("imageTopPosition").toInt(),
                null,
            )
            val pixels = whole.getRGB(0, 0, whole.width, whole.height, null, 0, whole.width)
            ShownFrame(IntArray(pixels.size) { pixels[it] and RGB }, control.getAttribute("delayTime").toInt())
        }
    }

    /** @property delay hundredths of a second. */
    private class ShownFrame(val pixels: IntArray, val delay: Int)
}
