package robotran.tower.rcx

import kotlinx.coroutines.async
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.runTest
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.tower.RcxVersion
import robotran.tower.Remains
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.simulated.AliveOnly
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import robotran.tower.simulated.SimulatedRom
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.seconds

class LegoFirmwareTest {
    private val lego = SimulatedLegoFirmware()
    private val main = ByteArray(450) { it.toByte() }
    private val sub = ByteArray(30) { 9 }
    private val program = RcxImage(
        FirmwareTarget.RCX,
        listOf(
            Chunk(ChunkId.MAIN, CodeBytes(main)),
            Chunk(ChunkId(ChunkKind.TASK, 3), CodeBytes.of(0x51, 1)),
            Chunk(ChunkId(ChunkKind.SUB, 7), CodeBytes(sub)),
        ),
    )

    @Test
    fun `a program gets into the slot that was asked for and replaces what is there`() = runTest {
        lego.parts["4 task 9"] = byteArrayOf(1)
        lego.parts["1 task 9"] = byteArrayOf(1)
        val result = TestLine(this, lego).tower.sendLegoProgram(4, program)
        assertEquals(TransferResult.Success(482, repeats = 0), result)
        assertEquals(setOf("4 task 0", "4 task 3", "4 sub 7", "1 task 9"), lego.parts.keys)
        assertContentEquals(main, lego.parts["4 task 0"])
        assertContentEquals(sub, lego.parts["4 sub 7"])
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
            assertIs<TransferResult.Success>(line.tower.sendLegoProgram(1, program), "seed $seed")
            assertContentEquals(main, lego.parts["1 task 0"])
        }
    }

    @Test
    fun `a program without room is refused and leaves nothing to run`() = runTest {
        val small = SimulatedLegoFirmware(room = 300)
        val result = TestLine(this, small).tower.sendLegoProgram(1, program)
        assertEquals(TransferResult.Failure(TowerError.TooLarge(482, null), Remains.NO_PROGRAM), result)
        assertEquals(emptySet(), small.parts.keys)
    }

    @Test
    fun `low batteries are told before anything is changed`() = runTest {
        val weak = SimulatedLegoFirmware(millivolts = 6100)
        weak.parts["1 task 0"] = byteArrayOf(1)
        val result = TestLine(this, weak).tower.sendLegoProgram(1, program)
        assertEquals(TransferResult.Failure(TowerError.BatteryLow(6100)), result)
        assertEquals(setOf("1 task 0"), weak.parts.keys)
    }

    @Test
    fun `a brick with another firmware, or none, keeps what it has`() = runTest {
        for (other in listOf(SimulatedLejos(), SimulatedRom(), AliveOnly())) {
            val tower = TestLine(this, other).tower
            assertEquals(TransferResult.Failure(TowerError.NoLegoFirmware), tower.sendLegoProgram(1, program))
            assertEquals(TowerResult.Failure(TowerError.NoLegoFirmware), tower.setLegoClock(hours = 1, minutes = 2))
            assertEquals(TowerResult.Failure(TowerError.NoLegoFirmware), tower.readLegoDatalog())
        }
    }

    @Test
    fun `a program for firmware 2_0 is not sent to firmware 1_0`() = runTest {
        val old = SimulatedLegoFirmware(version = 9)
        old.parts["1 task 0"] = byteArrayOf(1)
        val tower = TestLine(this, old).tower
        val tooOld = TransferResult.Failure(TowerError.LegoFirmwareTooOld(RcxVersion(3, 9)))
        assertEquals(tooOld, tower.sendLegoProgram(1, program.copy(target = FirmwareTarget.RCX2)))
        assertContentEquals(byteArrayOf(1), old.parts["1 task 0"])
        assertIs<TransferResult.Success>(tower.sendLegoProgram(1, program))
        val second = TestLine(this, SimulatedLegoFirmware(version = 28))
        assertIs<TransferResult.Success>(second.tower.sendLegoProgram(1, program.copy(target = FirmwareTarget.RCX2)))
    }

    @Test
    fun `a sound tells the end, and parts without code are not sent`() = runTest {
        val line = TestLine(this, lego)
        val empty = Chunk(ChunkId(ChunkKind.SUB, 0), CodeBytes.of())
        val result = line.tower.sendLegoProgram(1, program.copy(chunks = program.chunks + empty))
        assertEquals(TransferResult.Success(482, 0), result)
        assertEquals(listOf(5), lego.sounds)
        assertEquals(setOf("1 task 0", "1 task 3", "1 sub 7"), lego.parts.keys)
    }

    @Test
    fun `a brick that is switched off in the middle is told with what its slot can have`() = runTest {
        val early = TestLine(this, SimulatedLegoFirmware())
        val unchanged = async { early.tower.sendLegoProgram(1, program) }
        delay(100)
        early.brick.isOn = false
        assertEquals(TransferResult.Failure(TowerError.BrickSilent, Remains.AS_BEFORE), unchanged.await())
        val half = TestLine(this, SimulatedLegoFirmware())
        val empty = half.tower.sendLegoProgram(1, program) { if (it.confirmedBlocks == 1) half.brick.isOn = false }
        assertEquals(TransferResult.Failure(TowerError.BrickSilent, Remains.NO_PROGRAM), empty)
        val line = TestLine(this, SimulatedLegoFirmware())
        val result = async { line.tower.sendLegoProgram(1, program) }
        delay(5.seconds)
        line.port.unplug()
        assertEquals(TransferResult.Failure(TowerError.TowerGone, Remains.UNKNOWN), result.await())
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
