package robotran.rcxrom

import robotran.brick.log.CallLog
import robotran.brick.log.CallOutcome
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.log.RomLogEntry
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertNull
import kotlin.test.assertTrue

class RomLogTest {
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

    private fun addCalls(count: Int) {
        val call = RomCall(RomAddress.REFRESH_LCD, emptyList())
        repeat(count) { log.add(RomLogEntry(it.toLong(), call, "refresh the LCD", sourceLine = it, CallOutcome.DONE)) }
    }
}
