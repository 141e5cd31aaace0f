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
 * A [LoudSpeaker] that feeds a [SampleLine] on its own thread. It keeps the line open only while there is sound and for
 * [IDLE_MILLISECONDS] after.
 *
 * @param openLine opens the line; null if there is none, then this speaker stays silent.
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

    /** The line is open as long as it is visible under the lock. */
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

    /** Waits for the next sound; false if the line should be closed. */
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
        /** The time after the last sound until the line is closed. */
        const val IDLE_MILLISECONDS = 2_000L

        private const val CHUNK_SAMPLES = ToneWave.SAMPLE_RATE / 200 * ToneWave.CHANNELS
    }
}
