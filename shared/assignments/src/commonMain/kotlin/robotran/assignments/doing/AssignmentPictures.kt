package robotran.assignments.doing

import robotran.projects.AssignmentPicture
import kotlin.io.encoding.Base64

/**
 * The bytes of this picture, if they can be shown: those of a PNG or JPEG picture of at most [MAXIMUM_PIXELS]; otherwise
 * null. A small file could claim a picture that no device has memory for.
 */
fun AssignmentPicture.bytesToShow(): ByteArray? {
    val bytes = try {
        Base64.decode(base64)
    } catch (_: IllegalArgumentException) {
        return null
    }
    return bytes.takeIf { canBeShown(it) }
}

/** Whether [bytes] begin as a PNG or JPEG picture that has at most [MAXIMUM_PIXELS]. */
fun canBeShown(bytes: ByteArray): Boolean {
    val (width, height) = pngSize(bytes) ?: jpegSize(bytes) ?: return false
    return width > 0 && height > 0 && width.toLong() * height <= MAXIMUM_PIXELS
}

private fun pngSize(bytes: ByteArray): Pair<Int, Int>? {
    if (bytes.size < PNG_HEADER || !bytes.startsWith(PNG)) return null
    return bytes.number(PNG_WIDTH, 4) to bytes.number(PNG_WIDTH + 4, 4)
}

/** Looks for the segment that says the size; those before it say how long they are. */
private fun jpegSize(bytes: ByteArray): Pair<Int, Int>? {
    if (!bytes.startsWith(JPEG)) return null
    var place = 2
    while (place + JPEG_FRAME <= bytes.size && bytes.number(place, 1) == MARK) {
        val kind = bytes.number(place + 1, 1)
        if (kind in FRAMES && kind !in NO_FRAMES) return bytes.number(place + 7, 2) to bytes.number(place + 5, 2)
        place += 2 + bytes.number(place + 2, 2)
    }
    return null
}

private fun ByteArray.startsWith(start: List<Int>): Boolean =
    size >= start.size && start.indices.all { number(it, 1) == start[it] }

/** The whole number in [count] bytes, the most significant first. */
private fun ByteArray.number(offset: Int, count: Int): Int =
    (offset..<offset + count).fold(0) { sum, index -> (sum shl 8) or (this[index].toInt() and 0xFF) }

/** A photograph of a good phone. */
const val MAXIMUM_PIXELS = 16_000_000L
private val PNG = listOf(0x89, 0x50, 0x4E, 0x47)
private const val PNG_HEADER = 24
private const val PNG_WIDTH = 16
private val JPEG = listOf(0xFF, 0xD8, 0xFF)
private const val MARK = 0xFF
private const val JPEG_FRAME = 9
private val FRAMES = 0xC0..0xCF

/** Tables, which are not frames. */
private val NO_FRAMES = setOf(0xC4, 0xC8, 0xCC)
