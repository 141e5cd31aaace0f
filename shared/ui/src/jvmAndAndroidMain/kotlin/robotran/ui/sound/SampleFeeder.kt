package robotran.ui.sound

import robotran.workshop.sound.LoudSpeaker
import robotran.workshop.sound.PlannedTone
import robotran.workshop.sound.ToneWave
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.thread
import kotlin.concurrent.withLock

/**
 * A [LoudSpeaker] that feeds a [SampleLine] from a thread of its own, which holds the line only while there is
 * something to be heard and [IDLE_MILLISECONDS] after.
 *
 * @param openLine opens the line; null if this machine has none, then this speaker is silent for good.
 */
class SampleFeeder(private val openLine: () -> SampleLine?) : LoudSpeaker {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val wave = ToneWave()
    private var line: SampleLine? = null
    private var feeding = false
    private var closed = false

    override val milliseconds: Double get() = lock.withLock { wave.milliseconds }

    override fun play(tone: PlannedTone): Unit = lock.withLock {
        if (!closed) {
            wave.play(tone)
            if (!feeding) {
                feeding = true
                thread(isDaemon = true, name = "robotran-sound") { feed() }
            }
            changed.signalAll()
        }
    }

    override fun endAt(milliseconds: Double) = lock.withLock { wave.endAt(milliseconds) }

    /** The line is there as long as it can be reached under the lock. */
    override fun silence() = lock.withLock {
        wave.silence()
        line?.discard() ?: Unit
    }

    override fun close() {
        lock.withLock {
            closed = true
            changed.signalAll()
        }
        silence()
    }

    private fun feed() {
        val opened = openLine()
        lock.withLock { if (opened == null) closed = true else line = opened }
        if (opened == null) return
        val samples = ShortArray(CHUNK_SAMPLES)
        val bytes = ByteArray(CHUNK_SAMPLES * Short.SIZE_BYTES)
        val values = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asShortBuffer()
        while (takeNext(samples)) {
            values.clear()
            values.put(samples)
            opened.write(bytes)
        }
        opened.close()
    }

    /** Waits for something to be heard; false if it is time to give the line back. */
    private fun takeNext(samples: ShortArray): Boolean = lock.withLock {
        if (wave.isSilent && !closed) changed.await(IDLE_MILLISECONDS, TimeUnit.MILLISECONDS)
        val goesOn = !closed && !wave.isSilent
        if (goesOn) {
            wave.fill(samples)
        } else {
            feeding = false
            line = null
        }
        goesOn
    }

    companion object {
        /** How long after the last sound the line is kept. */
        const val IDLE_MILLISECONDS = 2_000L

        private const val CHUNK_SAMPLES = ToneWave.SAMPLE_RATE / 200
    }
}
