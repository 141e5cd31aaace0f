package robotran.ui.sound

import robotran.workshop.sound.ToneWave

/**
 * A way for samples to a sound card: sixteen bits with the low byte first, one channel, [ToneWave.SAMPLE_RATE] a
 * second. Used by one thread, but for [discard].
 */
interface SampleLine {
    /** Takes all of [samples], two bytes each; waits while about [BUFFER_MILLISECONDS] are still to be heard. */
    fun write(samples: ByteArray)

    /** Drops what was taken and not heard yet. Called from any thread. */
    fun discard()

    /** Gives the sound card back. */
    fun close()

    companion object {
        /**
         * Little enough for a tone to be heard soon, and much enough for the thread that feeds the line to be kept
         * waiting at times.
         */
        const val BUFFER_MILLISECONDS = 40

        /** The same in bytes. */
        const val BUFFER_BYTES = ToneWave.SAMPLE_RATE * BUFFER_MILLISECONDS / 1000 * Short.SIZE_BYTES
    }
}
