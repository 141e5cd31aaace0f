package robotran.animatedpicture

/** The frames of an animation, all of the same size. They are drawn when they are needed, some more than once. */
interface FrameSource {
    /** Pixels, 1..[AnimatedPictureLimits.MAX_SIDE]. */
    val width: Int

    /** Pixels, 1..[AnimatedPictureLimits.MAX_SIDE]. */
    val height: Int

    /** Number of frames, 1..[AnimatedPictureLimits.MAX_FRAMES]. */
    val count: Int

    /** Milliseconds that a frame is shown; a multiple of 10, since GIF counts in hundredths of a second. */
    val frameMilliseconds: Int

    /**
     * Draws the frame [index], 0..<[count], into all of [pixels]: rows from the top, `0xRRGGBB`; the highest byte is
     * ignored.
     */
    fun draw(index: Int, pixels: IntArray)
}

/** Fails if this source exceeds [AnimatedPictureLimits]. */
internal fun FrameSource.requireLimits() {
    require(width in 1..AnimatedPictureLimits.MAX_SIDE && height in 1..AnimatedPictureLimits.MAX_SIDE) {
        "A frame has 1 to ${AnimatedPictureLimits.MAX_SIDE} pixels per side, not $width x $height"
    }
    require(count in 1..AnimatedPictureLimits.MAX_FRAMES) {
        "An animation has 1 to ${AnimatedPictureLimits.MAX_FRAMES} frames, not $count"
    }
    require(frameMilliseconds > 0 && frameMilliseconds % MILLISECONDS_PER_DELAY == 0) {
        "A frame is shown for a multiple of $MILLISECONDS_PER_DELAY ms, not $frameMilliseconds"
    }
}

/** The unit of delays in a GIF file. */
internal const val MILLISECONDS_PER_DELAY = 10
