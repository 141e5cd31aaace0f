package robotran.workshop.platform

/** Reads photos, so that they can be made smaller. */
interface PhotoReader {
    /** The picture in the file [bytes]; null if it is none that the platform can read, or too large for it. */
    suspend fun read(bytes: ByteArray): Photo?
}

/** A picture in memory, upright whichever way the camera was held. */
interface Photo {
    val width: Int
    val height: Int

    /** The picture as a JPEG file, scaled to [width] by [height] pixels, on white. [quality] is 1..100. */
    suspend fun jpeg(width: Int, height: Int, quality: Int): ByteArray

    /** Releases its memory. It must not be used afterwards. */
    fun close()
}

/** A platform that cannot read pictures. */
object NoPhotoReader : PhotoReader {
    override suspend fun read(bytes: ByteArray): Photo? = null
}
