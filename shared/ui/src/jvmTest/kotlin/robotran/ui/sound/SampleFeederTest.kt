package robotran.ui.sound

import robotran.workshop.sound.PlannedTone
import robotran.workshop.sound.ToneWave
import java.util.concurrent.CountDownLatch
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

class SampleFeederTest {
    private val line = FakeLine()
    private val opened = AtomicInteger()
    private val feeder = SampleFeeder {
        opened.incrementAndGet()
        line
    }

    @AfterTest
    fun close() = feeder.close()

    @Test
    fun `the line is opened for the first tone and gets its samples`() {
        assertEquals(0, opened.get())
        feeder.play(PlannedTone(0.0, 1000.0, 20.0))
        assertTrue(line.next().any { it.toInt() != 0 })
        assertEquals(1, opened.get())
    }

    @Test
    fun `samples are written with the low byte first`() {
        feeder.play(PlannedTone(0.0, 1000.0, 20.0))
        val wave = ToneWave().also { it.play(PlannedTone(0.0, 1000.0, 20.0)) }
        val bytes = line.next()
        val samples = ShortArray(bytes.size / 2).also(wave::fill)
        assertEquals(
            samples.toList(),
            bytes.toList().chunked(2) { (low, high) ->
                ((high.toInt() shl 8) or (low.toInt() and 0xFF)).toShort()
            },
        )
    }

    @Test
    fun `the clock goes on as far as the line has taken samples`() {
        feeder.play(PlannedTone(0.0, 1000.0, 1_000.0))
        repeat(20) { line.next() }
        assertTrue(feeder.milliseconds >= 90)
    }

    @Test
    fun `silence drops at once what the line holds`() {
        feeder.play(PlannedTone(0.0, 1000.0, 2_000.0))
        line.next()
        feeder.silence()
        assertTrue(line.discarded.await(TEST_SECONDS, TimeUnit.SECONDS))
    }

    @Test
    fun `a line is given back when the speaker is closed`() {
        feeder.play(PlannedTone(0.0, 1000.0, 2_000.0))
        line.next()
        feeder.close()
        line.letPass()
        assertTrue(line.closed.await(TEST_SECONDS, TimeUnit.SECONDS))
    }

    @Test
    fun `a machine without a sound card is silent and is asked only once`() {
        val asked = CountDownLatch(1)
        val silent = SampleFeeder {
            asked.countDown()
            null
        }
        silent.play(PlannedTone(0.0, 1000.0, 20.0))
        assertTrue(asked.await(TEST_SECONDS, TimeUnit.SECONDS))
        repeat(5) { silent.play(PlannedTone(0.0, 1000.0, 20.0)) }
        silent.endAt(10.0)
        silent.silence()
        silent.close()
    }

    @Test
    fun `who plays a tone does not wait for a sound card that takes its time`() {
        val answer = CountDownLatch(1)
        val slow = SampleFeeder {
            answer.await()
            null
        }
        slow.play(PlannedTone(0.0, 1000.0, 20.0))
        slow.silence()
        slow.close()
        answer.countDown()
    }

    /** Accepts a chunk only when the test requests one, like a line that waits for its sound card. */
    private class FakeLine : SampleLine {
        private val chunks = LinkedBlockingQueue<ByteArray>(1)

        @Volatile
        private var open = true
        val discarded = CountDownLatch(1)
        val closed = CountDownLatch(1)

        fun next(): ByteArray = assertNotNull(chunks.poll(TEST_SECONDS, TimeUnit.SECONDS), "no samples come")

        fun letPass() {
            open = false
            chunks.poll()
        }

        override fun write(samples: ByteArray) {
            if (open) chunks.put(samples.copyOf())
        }

        override fun discard() = discarded.countDown()

        override fun close() = closed.countDown()
    }

    private companion object {
        /** Longer than any successful step takes. */
        const val TEST_SECONDS = 20L
    }
}
