package robotran.animatedpicture

/** Frames given as a list of pixels. */
internal class TestFrames(
    override val width: Int,
    private val frames: List<IntArray>,
    override val frameMilliseconds: Int = 80,
) : FrameSource {
    override val height: Int get() = frames.first().size / width
    override val count: Int get() = frames.size

    override fun draw(index: Int, pixels: IntArray) {
        frames[index].copyInto(pixels)
    }
}

internal fun gifOf(source: FrameSource): ByteArray = (animatedGif(source).last() as AnimationStep.Finished).bytes
