package robotran.workshop.platform

import robotran.animatedpicture.FrameSource

/** Records videos. Such a video takes as long to record as it lasts. */
interface VideoRecorder {
    /** Whether this machine can record. */
    val isAvailable: Boolean

    /**
     * Plays [source] once, and calls [onFrame] with the number of frames shown so far. Cancelling the coroutine ends the
     * recording. Returns a WebM file; null if the recorder failed.
     */
    suspend fun record(source: FrameSource, onFrame: (Int) -> Unit): ByteArray?
}

/** A platform without videos. */
object NoVideoRecorder : VideoRecorder {
    override val isAvailable: Boolean get() = false

    override suspend fun record(source: FrameSource, onFrame: (Int) -> Unit): ByteArray? = null
}
