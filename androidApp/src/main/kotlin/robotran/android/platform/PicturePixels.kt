package robotran.android.platform

import android.graphics.BitmapFactory
import robotran.workshop.platform.Pixels

/** The picture in the file [bytes], made smaller if it is very large; null if it is none that Android reads. */
internal fun pixelsIn(bytes: ByteArray): Pixels? {
    val bounds = BitmapFactory.Options().apply { inJustDecodeBounds = true }
    BitmapFactory.decodeByteArray(bytes, 0, bytes.size, bounds)
    val options = BitmapFactory.Options()
    while (maxOf(bounds.outWidth, bounds.outHeight) / options.inSampleSize.coerceAtLeast(1) > MOST_PIXELS) {
        options.inSampleSize = options.inSampleSize.coerceAtLeast(1) * 2
    }
    val picture = BitmapFactory.decodeByteArray(bytes, 0, bytes.size, options) ?: return null
    val colours = IntArray(picture.width * picture.height)
    picture.getPixels(colours, 0, picture.width, 0, 0, picture.width, picture.height)
    return Pixels(picture.width, picture.height, colours)
}

/** For the longer side. */
private const val MOST_PIXELS = 4096
