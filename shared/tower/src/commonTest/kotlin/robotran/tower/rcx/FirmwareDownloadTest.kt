package robotran.tower.rcx

import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.runTest
import robotran.tower.BrickStatus
import robotran.tower.RcxVersion
import robotran.tower.Remains
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferResult
import robotran.tower.firmware.FirmwareImage
import robotran.tower.firmware.FirmwareKind
import robotran.tower.port.TowerKind
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import robotran.tower.simulated.SimulatedRom
import robotran.tower.smallImage
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.seconds

class FirmwareDownloadTest {
    private val bytes = ByteArray(1000) { (it * 31).toByte() } + "Do you byte, when I knock?".encodeToByteArray()
    private val firmware = FirmwareImage(bytes, 0x8000, FirmwareKind.UNKNOWN)

    @Test
    fun `a brick without firmware gets leJOS and then a program`() = runTest {
        for (kind in TowerKind.entries) {
            val rom = SimulatedRom()
            val line = TestLine(this, rom, kind)
            assertEquals(TransferResult.Success(bytes.size, repeats = 0), line.tower.sendFirmware(firmware))
            assertContentEquals(bytes, rom.received)
            assertEquals(0x8000, rom.start)
            val lejos = assertIs<SimulatedLejos>(line.brick.firmware)
            assertIs<TransferResult.Success>(line.tower.sendProgram(smallImage))
            assertContentEquals(smallImage, lejos.program)
        }
    }

    @Test
    fun `a firmware replaces leJOS and LEGO's`() = runTest {
        for (old in listOf(SimulatedLejos(), SimulatedLegoFirmware())) {
            val line = TestLine(this, old)
            assertIs<TransferResult.Success>(line.tower.sendFirmware(firmware))
            assertTrue(line.brick.firmware !== old)
            assertIs<SimulatedLejos>(line.brick.firmware)
        }
    }

    @Test
    fun `a firmware arrives though bytes are lost`() = runTest(timeout = 60.seconds) {
        for (seed in 1..4) {
            val rom = SimulatedRom(if (seed % 2 == 0) ({ SimulatedLejos() }) else ({ SimulatedLegoFirmware() }))
            val line = TestLine(this, rom, faults = LineFaults(seed, loss = 0.02))
            assertIs<TransferResult.Success>(line.tower.sendFirmware(firmware), "seed $seed")
            assertContentEquals(bytes, rom.received)
            assertTrue(line.brick.firmware !is SimulatedRom)
        }
    }

    @Test
    fun `a firmware that the ROM does not start is refused`() = runTest {
        val line = TestLine(this, SimulatedRom())
        val useless = FirmwareImage(ByteArray(300), 0x8000, FirmwareKind.UNKNOWN)
        val refused = TransferResult.Failure(TowerError.FirmwareRefused, Remains.NO_FIRMWARE)
        assertEquals(refused, line.tower.sendFirmware(useless))
        assertIs<SimulatedRom>(line.brick.firmware)
    }

    @Test
    fun `a brick that is off is silent`() = runTest {
        val line = TestLine(this, SimulatedRom())
        line.brick.isOn = false
        assertEquals(TransferResult.Failure(TowerError.BrickSilent), line.tower.sendFirmware(firmware))
    }

    @Test
    fun `a download that is cancelled leaves the ROM and can begin again`() = runTest {
        for (milliseconds in 500..10_000L step 1031) {
            val line = TestLine(this, SimulatedRom())
            val job = launch { line.tower.sendFirmware(firmware) }
            delay(milliseconds)
            job.cancelAndJoin()
            delay(5.seconds)
            assertIs<SimulatedRom>(line.brick.firmware)
            assertIs<TransferResult.Success>(line.tower.sendFirmware(firmware), "after $milliseconds ms")
            assertEquals(
                TowerResult.Success(BrickStatus.LejosOrNoFirmware(RcxVersion(3, 1))),
                line.tower.status(),
            )
        }
    }
}
