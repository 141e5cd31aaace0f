package robotran.ui.golden

import org.jetbrains.skia.Bitmap
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.FilterMipmap
import org.jetbrains.skia.FilterMode
import org.jetbrains.skia.Image
import org.jetbrains.skia.ImageInfo
import org.jetbrains.skia.MipmapMode
import java.io.File
import kotlin.math.abs
import kotlin.test.fail

/**
 * Compares screenshots with reviewed reference images. The references have a quarter of the size and are compared by
 * the mean colours of tiles: other fonts and smoothing pass, a missing pane, button or colour fails.
 *
 * `-PrecordPictures` saves the current pictures as references, for review.
 */
internal object GoldenPicture {
    private val kept = File("src/jvmTest/resources/golden")
    private val seen = File(System.getProperty("robotran.pictures"), "golden").apply { mkdirs() }
    private val recording = System.getProperty("robotran.recordPictures") != null

    /** Fails if [picture] differs from the reference [name]. */
    fun check(name: String, picture: Image) {
        val small = quarterOf(picture)
        kept.mkdirs()
        compare(name, picture, File(kept, "$name.png"), small) { it }
    }

    /** Fails if [picture] differs from that of the pages of that [name], which is kept in full size. */
    fun checkPage(name: String, picture: Image) =
        compare(name, picture, File("../../docs/pictures/$name.png"), picture, ::quarterOf)

    private fun compare(name: String, picture: Image, file: File, recorded: Image, reduce: (Image) -> Image) {
        if (recording) {
            show(name, picture)
            file.writeBytes(bytesOf(recorded))
        }
        if (!file.exists()) fail("There is no picture $name yet: look at ${show(name, picture)} and record it.")
        val wanted = reduce(Image.makeFromEncoded(file.readBytes()))
        val other = share(tilesOf(reduce(recorded)), tilesOf(wanted))
        if (other > MAX_OTHER_TILES) {
            fail("$name looks different: ${(other * 100).toInt()} % of its tiles. See ${show(name, picture)}.")
        }
    }

    /** Saves [picture] for review. */
    private fun show(name: String, picture: Image): File =
        File(seen, "$name.png").apply { writeBytes(bytesOf(picture)) }

    private fun share(seen: List<IntArray>, wanted: List<IntArray>): Double {
        if (seen.size != wanted.size) return 1.0
        val other = seen.zip(wanted).count { (a, b) -> a.indices.maxOf { abs(a[it] - b[it]) } > MAX_DIFFERENCE }
        return other.toDouble() / seen.size
    }

    private fun quarterOf(picture: Image): Image {
        val bitmap = Bitmap()
        bitmap.allocPixels(ImageInfo.makeN32Premul(picture.width / SCALE, picture.height / SCALE))
        picture.scalePixels(
            checkNotNull(bitmap.peekPixels()),
            FilterMipmap(FilterMode.LINEAR, MipmapMode.LINEAR),
            false,
        )
        return Image.makeFromBitmap(bitmap.setImmutable())
    }

    /** The mean red, green and blue of each tile. */
    private fun tilesOf(picture: Image): List<IntArray> {
        val bitmap = Bitmap.makeFromImage(picture)
        return (0 until picture.height - TILE + 1 step TILE).flatMap { top ->
            (0 until picture.width - TILE + 1 step TILE).map { left -> meanOf(bitmap, left, top) }
        }
    }

    private fun meanOf(bitmap: Bitmap, left: Int, top: Int): IntArray {
        val sums = IntArray(3)
        for (y in top until top + TILE) {
            for (x in left until left + TILE) {
                val colour = bitmap.getColor(x, y)
                for (part in sums.indices) sums[part] += (colour shr (16 - 8 * part)) and 0xFF
            }
        }
        return IntArray(3) { sums[it] / (TILE * TILE) }
    }

    private fun bytesOf(image: Image) = checkNotNull(image.encodeToData(EncodedImageFormat.PNG)).bytes

    private const val SCALE = 4

    /** In pixels of the reduced picture: 40 pixels of the screen. */
    private const val TILE = 10

    /** Of 255: the change of a tile's mean by text in another font, or by a line one pixel off. */
    private const val MAX_DIFFERENCE = 14
    private const val MAX_OTHER_TILES = 0.04
}
