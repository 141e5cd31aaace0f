package robotran.animatedpicture

/** The limits of an animated picture, which bound its time and memory. */
object AnimatedPictureLimits {
    /** Pixels per side. */
    const val MAX_SIDE = 1_024

    /** Number of frames of a [FrameSource]. */
    const val MAX_FRAMES = 1_200

    /** Bytes of a file: mail programs and messengers refuse larger ones. */
    const val MAX_BYTES = 20_000_000
}
