package robotran.ui.sound

import robotran.workshop.sound.ToneWave

/**
 * Sends samples to a sound card: 16-bit stereo, little-endian, [ToneWave.SAMPLE_RATE] per second and ear. Used by one thread,
 * except for [discard].
 */
interface SampleLine {
    /** Plays [samples], two bytes each, left and right in turn; blocks while about [BUFFER_MILLISECONDS] are buffered. */
    fun write(samples: ByteArray)

    /** Drops the buffered samples. Thread-safe. */
    fun discard()

    /** Releases the sound card. */
    fun close()

    companion object {
        /** Short enough for low latency, but long enough to block the feeding thread. */
        const val BUFFER_MILLISECONDS = 40

        /** The same in bytes. */
        const val BUFFER_BYTES =
            ToneWave.SAMPLE_RATE * BUFFER_MILLISECONDS / 1000 * ToneWave.CHANNELS * Short.SIZE_BYTES
    }
}
