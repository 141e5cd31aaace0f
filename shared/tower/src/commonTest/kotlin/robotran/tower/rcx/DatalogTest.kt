package robotran.tower.rcx

import kotlinx.coroutines.test.runTest
import robotran.legofirmware.device.DatalogEntry
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedLegoFirmware
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class DatalogTest {
    private val entries = List(123) { (0x40 + it % 3) to (it * 523 - 32_000) }
    private val expected = TowerResult.Success(entries.map { (type, value) -> DatalogEntry(type, value) })
    private val lego = SimulatedLegoFirmware().also { it.datalog = entries }

    @Test
    fun `all entries come in their order, in few messages`() = runTest {
        val line = TestLine(this, lego)
        val reports = mutableListOf<TransferProgress>()
        assertEquals(expected, line.tower.readLegoDatalog { reports += it })
        assertEquals(listOf(0, 50, 100, 123), reports.map { it.confirmedBlocks })
        assertEquals(0, reports.last().secondsLeft)
        assertEquals(4, line.brick.messages.count { it[0].toInt() and 0xF7 == 0xA4 })
        assertEquals(entries, lego.datalog)
    }

    @Test
    fun `a brick without datalog, and one with an empty one, have no entries`() = runTest {
        for (none in listOf(null, emptyList<Pair<Int, Int>>())) {
            lego.datalog = none
            val result: TowerResult<List<DatalogEntry>> = TowerResult.Success(emptyList())
            assertEquals(result, TestLine(this, lego).tower.readLegoDatalog())
        }
    }

    @Test
    fun `a brick that answers everything but this has none, and one that is off is silent`() = runTest {
        val line = TestLine(this, lego)
        line.brick.isDeafTo = 0xA4
        val none: TowerResult<List<DatalogEntry>> = TowerResult.Success(emptyList())
        assertEquals(none, line.tower.readLegoDatalog())
        line.brick.isOn = false
        assertEquals(TowerResult.Failure(TowerError.BrickSilent), line.tower.readLegoDatalog())
    }

    @Test
    fun `on a bad line the entries come in smaller parts`() = runTest {
        for (seed in 1..5) {
            val line = TestLine(this, lego, faults = LineFaults(seed, loss = 0.02, corrupted = 0.01))
            assertEquals(expected, line.tower.readLegoDatalog(), "seed $seed")
        }
    }

    @Test
    fun `a number of entries that no brick can have is none`() = runTest {
        lego.datalog = List(12_000) { 0 to 0 }
        val result = TestLine(this, lego).tower.readLegoDatalog()
        assertTrue(result is TowerResult.Success && result.value.isEmpty(), "$result")
    }
}
