package robotran.animatedpicture

/** A step on the way to an animated picture. */
sealed interface AnimationStep {
    /** [done] of [total] frames are drawn. */
    data class Progress(val done: Int, val total: Int) : AnimationStep

    /** The file is complete. */
    class Finished(val bytes: ByteArray) : AnimationStep

    /** The file would exceed [AnimatedPictureLimits.MAX_BYTES]. */
    data object TooLarge : AnimationStep
}

/**
 * Makes an animated GIF of [source] that repeats for ever. Each element is the work of about one frame, so a caller can
 * do other work between two, or stop. The last element is [AnimationStep.Finished] or [AnimationStep.TooLarge]. The
 * same pixels give the same bytes on every platform.
 *
 * First draws a few frames to choose 255 colours from, then all frames in order.
 *
 * @param restMilliseconds how much longer the last frame is shown before the animation repeats.
 */
fun animatedGif(source: FrameSource, restMilliseconds: Int = REST_MILLISECONDS): Sequence<AnimationStep> = sequence {
    source.requireLimits()
    val samples = samplesOf(source.count)
    val total = samples.size + source.count
    val pixels = IntArray(source.width * source.height)
    val colours = ColourCounts()
    for ((done, index) in samples.withIndex()) {
        source.draw(index, pixels)
        colours.add(pixels)
        yield(AnimationStep.Progress(done + 1, total))
    }
    val writer = GifWriter(source.width, source.height, paletteFor(colours.sorted()))
    for (index in 0..<source.count) {
        source.draw(index, pixels)
        val rest = if (index == source.count - 1) restMilliseconds else 0
        writer.add(pixels, (source.frameMilliseconds + rest) / MILLISECONDS_PER_DELAY)
        if (writer.size > AnimatedPictureLimits.MAX_BYTES) {
            yield(AnimationStep.TooLarge)
            return@sequence
        }
        yield(AnimationStep.Progress(samples.size + index + 1, total))
    }
    val bytes = writer.finish()
    yield(if (bytes.size > AnimatedPictureLimits.MAX_BYTES) AnimationStep.TooLarge else AnimationStep.Finished(bytes))
}

/** Frames at equal distances, with the first and the last. */
private fun samplesOf(count: Int): List<Int> {
    val wanted = minOf(SAMPLES, count)
    return (0..<wanted).map { if (wanted == 1) 0 else ((count - 1).toLong() * it / (wanted - 1)).toInt() }
}

/** Lamps that go on or off, the most colourful change of a sheet, show in one of these frames at least. */
private const val SAMPLES = 8

/** Long enough to look at the finished drawing. */
private const val REST_MILLISECONDS = 2_000
