package robotran.brick.log

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertNull
import kotlin.test.assertTrue

class CallLogTest {
    private val log = CallLog()

    @Test
    fun `entries are in the order of the calls`() {
        addCalls(2_500)
        assertEquals((0 until 2_500).toList(), log.entries.map { it.sourceLine })
        assertEquals(2_500L, log.total)
    }

    @Test
    fun `a list once taken does not grow`() {
        addCalls(3)
        val taken = log.entries
        addCalls(2_000)
        assertEquals(listOf(0, 1, 2), taken.map { it.sourceLine })
        assertFailsWith<IndexOutOfBoundsException> { taken[3] }
    }

    @Test
    fun `a call can be found by its number`() {
        addCalls(1_500)
        assertEquals(0, log[0]?.sourceLine)
        assertEquals(1_499, log[1_499]?.sourceLine)
        assertNull(log[1_500])
        assertNull(log[-1])
    }

    @Test
    fun `the oldest calls are forgotten and still counted`() {
        val calls = CallLog.CAPACITY + 50_000
        addCalls(calls)
        val entries = log.entries
        assertEquals(calls.toLong(), log.total)
        assertTrue(entries.size in CallLog.CAPACITY..CallLog.CAPACITY + 1_000)
        assertEquals(calls - entries.size, entries.first().sourceLine)
        assertEquals(calls - 1, entries.last().sourceLine)
        assertNull(log[0])
        assertEquals(calls - 1, log[calls - 1L]?.sourceLine)
    }

    @Test
    fun `the last call can be amended, and no other`() {
        log.amendLast { error("There is none.") }
        addCalls(1_001)
        log.amendLast { ShownCall(it.milliseconds, sourceLine = 7) }
        assertEquals(7, log[1_000]?.sourceLine)
        assertEquals(999, log[999]?.sourceLine)
        assertEquals(1_001L, log.total)
    }

    private fun addCalls(count: Int) = repeat(count) { log.add(ShownCall(it.toLong(), sourceLine = it)) }
}
