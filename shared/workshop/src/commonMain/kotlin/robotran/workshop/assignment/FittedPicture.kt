package robotran.workshop.assignment

import robotran.assignments.doing.canBeShown
import robotran.projects.AssignmentLimits
import robotran.workshop.platform.Photo
import robotran.workshop.platform.PhotoReader
import robotran.workshop.state.PictureError
import robotran.workshop.state.PictureSize
import kotlin.math.roundToInt

/** A picture that fits into an assignment, or why there is none. */
internal sealed interface FittedPicture {
    /** @property madeSmaller its size if it had to be made smaller. */
    class Success(val bytes: ByteArray, val madeSmaller: PictureSize?) : FittedPicture

    data class Failure(val error: PictureError) : FittedPicture
}

/**
 * The picture in the file [bytes]. One that is too large is made smaller, with as many pixels as fit at a quality at
 * which nobody sees the loss.
 */
internal suspend fun fitPicture(bytes: ByteArray, reader: PhotoReader): FittedPicture {
    if (canBeShown(bytes) && bytes.size <= MAX_BYTES) return FittedPicture.Success(bytes, madeSmaller = null)
    val photo = reader.read(bytes) ?: return FittedPicture.Failure(
        when {
            isHeic(bytes) -> PictureError.HEIC
            canBeShown(bytes) -> PictureError.TOO_LARGE
            else -> PictureError.NOT_A_PICTURE
        },
    )
    try {
        return madeSmaller(photo)
    } finally {
        photo.close()
    }
}

private suspend fun madeSmaller(photo: Photo): FittedPicture {
    val longer = maxOf(photo.width, photo.height)
    for (side in LONGER_SIDES.map { minOf(it, longer) }.distinct()) {
        val scale = side.toDouble() / longer
        val size = PictureSize(
            (photo.width * scale).roundToInt().coerceAtLeast(1),
            (photo.height * scale).roundToInt().coerceAtLeast(1),
        )
        for (quality in QUALITIES) {
            val jpeg = photo.jpeg(size.width, size.height, quality)
            if (jpeg.size <= MAX_BYTES) return FittedPicture.Success(jpeg, size)
        }
    }
    return FittedPicture.Failure(PictureError.TOO_LARGE)
}

/** Whether [bytes] begin as the container of an iPhone's photos. */
private fun isHeic(bytes: ByteArray): Boolean {
    val start = bytes.copyOf(BRAND_END).map { it.toInt().toChar() }.joinToString("")
    return start.substring(BRAND_MARK) in HEIC_BRANDS.map { "ftyp$it" }
}

/** Of [AssignmentLimits.MAXIMUM_PICTURE_CHARACTERS] of Base64. */
private const val MAX_BYTES = AssignmentLimits.MAXIMUM_PICTURE_CHARACTERS / 4 * 3

/** In pixels. More would be lost on the screens of pupils. */
private val LONGER_SIDES = listOf(1600, 1400, 1200, 1000, 800, 600, 400, 200)

/** Below, blocks are seen. */
private val QUALITIES = listOf(85, 75)
private const val BRAND_MARK = 4
private const val BRAND_END = 12
private val HEIC_BRANDS = listOf("heic", "heix", "heim", "heis", "hevc", "hevx", "mif1", "msf1")
