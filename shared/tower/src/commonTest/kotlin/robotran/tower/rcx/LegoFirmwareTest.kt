package robotran.tower.rcx

import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.runTest
import robotran.tower.LegoPartKind
import robotran.tower.LegoProgram
import robotran.tower.LegoProgramPart
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.seconds

class LegoFirmwareTest {
    private val lego = SimulatedLegoFirmware()
    private val main = LegoProgramPart(LegoPartKind.TASK, 0, ByteArray(450) { it.toByte() })
    private val second = LegoProgramPart(LegoPartKind.TASK, 3, byteArrayOf(0x51, 1))
    private val sub = LegoProgramPart(LegoPartKind.SUBROUTINE, 7, ByteArray(30) { 9 })
    private val program = LegoProgram(listOf(main, second, sub))

    @Test
    fun `a program gets into the slot that was asked for and replaces what is there`() = runTest {
        lego.parts["4 task 9"] = byteArrayOf(1)
        lego.parts["1 task 9"] = byteArrayOf(1)
        val result = TestLine(this, lego).tower.sendLegoProgram(4, program)
        assertEquals(TransferResult.Complete(482, repeats = 0), result)
        assertEquals(setOf("4 task 0", "4 task 3", "4 sub 7", "1 task 9"), lego.parts.keys)
        assertContentEquals(main.code, lego.parts["4 task 0"])
        assertContentEquals(sub.code, lego.parts["4 sub 7"])
    }

    @Test
    fun `progress goes through all parts`() = runTest {
        val reports = mutableListOf<TransferProgress>()
        TestLine(this, lego).tower.sendLegoProgram(1, program) { reports += it }
        assertTrue(reports.zipWithNext().all { (a, b) -> a.confirmedBlocks <= b.confirmedBlocks }, "$reports")
        assertEquals(
            TransferProgress(confirmedBlocks = 5, totalBlocks = 5, repeats = 0, secondsLeft = 0),
            reports.last(),
        )
    }

    @Test
    fun `a program arrives though bytes are lost`() = runTest {
        for (seed in 1..10) {
            val lego = SimulatedLegoFirmware()
            val line = TestLine(this, lego, faults = LineFaults(seed, loss = 0.02))
            assertIs<TransferResult.Complete>(line.tower.sendLegoProgram(1, program), "seed $seed")
            assertContentEquals(main.code, lego.parts["1 task 0"])
        }
    }

    @Test
    fun `a program without room is refused and leaves nothing to run`() = runTest {
        val small = SimulatedLegoFirmware(room = 300)
        val result = TestLine(this, small).tower.sendLegoProgram(1, program)
        assertEquals(TransferResult.Failed(TowerError.TooLarge(450, null)), result)
        assertEquals(setOf("1 sub 7"), small.parts.keys)
    }

    @Test
    fun `low batteries are told before anything is changed`() = runTest {
        val weak = SimulatedLegoFirmware(millivolts = 6100)
        weak.parts["1 task 0"] = byteArrayOf(1)
        val result = TestLine(this, weak).tower.sendLegoProgram(1, program)
        assertEquals(TransferResult.Failed(TowerError.BatteryLow(6100)), result)
        assertEquals(setOf("1 task 0"), weak.parts.keys)
    }

    @Test
    fun `leJOS has no slots`() = runTest {
        val result = TestLine(this, SimulatedLejos()).tower.sendLegoProgram(1, program)
        assertEquals(TransferResult.Failed(TowerError.NoLegoFirmware), result)
    }

    @Test
    fun `a download that is cancelled leaves no main task`() = runTest {
        for (milliseconds in 700..5_500L step 211) {
            val lego = SimulatedLegoFirmware()
            val line = TestLine(this, lego)
            val job = launch { line.tower.sendLegoProgram(1, program) }
            delay(milliseconds)
            assertTrue(job.isActive, "the download takes longer than $milliseconds ms")
            job.cancelAndJoin()
            delay(5.seconds)
            assertFalse(lego.parts.keys.any { "task" in it }, "after $milliseconds ms: ${lego.parts.keys}")
        }
    }

    @Test
    fun `programs are selected, started, stopped and deleted`() = runTest {
        val tower = TestLine(this, lego).tower
        tower.sendLegoProgram(2, program)
        assertEquals(TowerResult.Success(Unit), tower.selectLegoSlot(5))
        assertEquals(5, lego.slot)
        tower.selectLegoSlot(2)
        assertEquals(TowerResult.Success(Unit), tower.startLegoProgram())
        assertTrue(lego.isRunning)
        assertEquals(TowerResult.Success(Unit), tower.stopLegoProgram())
        assertFalse(lego.isRunning)
        assertEquals(TowerResult.Success(Unit), tower.deleteLegoProgram(2))
        assertEquals(emptySet(), lego.parts.keys)
    }

    @Test
    fun `the clock is set`() = runTest {
        assertEquals(TowerResult.Success(Unit), TestLine(this, lego).tower.setLegoClock(hours = 13, minutes = 37))
        assertEquals(13 to 37, lego.clock)
    }

    @Test
    fun `a message is sent and the same one again`() = runTest {
        val line = TestLine(this, lego)
        assertEquals(TowerResult.Success(Unit), line.tower.sendMessage(42))
        assertEquals(42, lego.message)
        line.tower.sendMessage(42)
        assertEquals(listOf(0xF7, 0xFF), line.brick.messages.map { it[0].toInt() and 0xFF })
    }
}
