package robotran.desktop.platform

import robotran.workshop.platform.Pixels
import java.io.IOException
import javax.imageio.ImageIO

/** The picture in the file [bytes]; null if it is none that Java reads. */
internal fun pixelsIn(bytes: ByteArray): Pixels? {
    val picture = try {
        ImageIO.read(bytes.inputStream())
    } catch (_: IOException) {
        null
    } ?: return null
    val (width, height) = picture.width to picture.height
    return Pixels(width, height, picture.getRGB(0, 0, width, height, null, 0, width))
}
