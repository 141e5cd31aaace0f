package robotran.tower.rcx

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.async
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.currentTime
import kotlinx.coroutines.test.runTest
import robotran.tower.BrickMemory
import robotran.tower.RcxVersion
import robotran.tower.Remains
import robotran.tower.TowerError
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.largestImage
import robotran.tower.port.TowerKind
import robotran.tower.simulated.AliveOnly
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import robotran.tower.simulated.SimulatedRom
import robotran.tower.smallImage
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.seconds

@OptIn(ExperimentalCoroutinesApi::class)
class ProgramDownloadTest {
    private val lejos = SimulatedLejos()

    private fun failed(error: TowerError) = TransferResult.Failure(error)

    private fun lost(error: TowerError) = TransferResult.Failure(error, Remains.NO_PROGRAM)

    @Test
    fun `the largest example takes at most a third more than the line allows`() = runTest {
        for (kind in TowerKind.entries) {
            val lejos = SimulatedLejos()
            val start = currentTime
            val result = TestLine(this, lejos, kind).tower.sendProgram(largestImage)
            assertEquals(TransferResult.Success(6565, repeats = 0), result)
            assertContentEquals(largestImage, lejos.program)
            // Without any message or answer, 6565 bytes with their complements.
            val least = 2 * 6565 * 11 * 1000 / 2400
            val share = (currentTime - start).toDouble() / least
            assertTrue(share < 1.3, "$kind: $share times the least time")
        }
    }

    @Test
    fun `an image arrives through the USB tower though 5 percent of all bytes are lost`() = runTest {
        val line = TestLine(this, lejos, TowerKind.USB, LineFaults(seed = 22, loss = 0.05))
        assertIs<TransferResult.Success>(line.tower.sendProgram(smallImage))
        assertContentEquals(smallImage, lejos.program)
    }

    @Test
    fun `an image of the least size has two blocks`() = runTest {
        val image = smallImage.copyOf(16)
        val line = TestLine(this, lejos)
        assertEquals(TransferResult.Success(16, repeats = 0), line.tower.sendProgram(image))
        assertContentEquals(image, lejos.program)
        assertEquals(listOf(1, 0), line.brick.messages.takeLast(2).map { it[1].toInt() })
    }

    @Test
    fun `the largest image fits and a larger one is refused before anything is sent`() = runTest {
        val most = smallImage.copyOf(BrickMemory.MAX_LEJOS_IMAGE)
        assertIs<TransferResult.Success>(TestLine(this, lejos).tower.sendProgram(most))
        assertContentEquals(most, lejos.program)
        val line = TestLine(this, SimulatedLejos())
        val result = line.tower.sendProgram(smallImage.copyOf(BrickMemory.MAX_LEJOS_IMAGE + 1))
        assertEquals(failed(TowerError.TooLarge(13_789, 13_788)), result)
        assertEquals(emptyList(), line.port.sent)
    }

    @Test
    fun `an image for leJOS 2·1 does not fit beside 3·0 and is told so`() = runTest {
        val image = smallImage.copyOf(14_000)
        val old = SimulatedLejos(room = 14_680)
        val max = BrickMemory.MAX_LEJOS_2_1_IMAGE
        assertIs<TransferResult.Success>(TestLine(this, old).tower.sendProgram(image, max))
        assertContentEquals(image, old.program)
        assertEquals(lost(TowerError.TooLarge(14_000, 13_788)), TestLine(this, lejos).tower.sendProgram(image, max))
        assertNull(lejos.program)
    }

    @Test
    fun `progress counts blocks and the time left falls`() = runTest {
        val reports = mutableListOf<TransferProgress>()
        TestLine(this, lejos).tower.sendProgram(largestImage) { reports += it }
        assertEquals(0, reports.first().confirmedBlocks)
        assertTrue(reports.first().secondsLeft in 60..70, "${reports.first()}")
        assertEquals(reports.last().totalBlocks, reports.last().confirmedBlocks)
        assertEquals(0, reports.last().secondsLeft)
        assertTrue(reports.zipWithNext().all { (a, b) -> a.secondsLeft >= b.secondsLeft })
    }

    @Test
    fun `doubled and wrong bytes do no harm`() = runTest {
        val faults = LineFaults(seed = 7, doubled = 0.003, corrupted = 0.003)
        assertIs<TransferResult.Success>(TestLine(this, lejos, faults = faults).tower.sendProgram(largestImage))
        assertContentEquals(largestImage, lejos.program)
    }

    @Test
    fun `a line that is a second late does no harm`() = runTest {
        val faults = LineFaults(seed = 3, delayed = 0.002, delayMilliseconds = 1000)
        assertIs<TransferResult.Success>(TestLine(this, lejos, faults = faults).tower.sendProgram(smallImage))
        assertContentEquals(smallImage, lejos.program)
    }

    @Test
    fun `a brick that waits for the rest of another download begins anew`() = runTest {
        lejos.handle(byteArrayOf(0x12, 0xCA.toByte(), 0xF6.toByte()))
        assertIs<TransferResult.Success>(TestLine(this, lejos).tower.sendProgram(smallImage))
        assertContentEquals(smallImage, lejos.program)
    }

    @Test
    fun `a brick that is switched off and on begins anew`() = runTest {
        val line = TestLine(this, lejos)
        val result = async { line.tower.sendProgram(largestImage) }
        delay(20.seconds)
        lejos.switchOffAndOn()
        assertIs<TransferResult.Success>(result.await())
        assertContentEquals(largestImage, lejos.program)
    }

    @Test
    fun `a brick that is switched off in the middle is missed within 15 seconds`() = runTest {
        for (kind in TowerKind.entries) {
            val line = TestLine(this, lejos, kind)
            val result = async { line.tower.sendProgram(largestImage) to currentTime }
            delay(20.seconds)
            line.brick.isOn = false
            val off = currentTime
            val (outcome, end) = result.await()
            assertEquals(lost(TowerError.BrickSilent), outcome)
            assertTrue(end - off < 15_000, "$kind: ${end - off} ms")
        }
    }

    @Test
    fun `a brick that is switched off before the last block is missed within 15 seconds`() = runTest {
        val line = TestLine(this, lejos)
        var off = 0L
        val result = line.tower.sendProgram(largestImage) { progress ->
            if (line.brick.isOn && progress.confirmedBlocks == progress.totalBlocks - 1) {
                line.brick.isOn = false
                off = currentTime
            }
        }
        assertEquals(lost(TowerError.BrickSilent), result)
        assertTrue(currentTime - off < 15_000, "${currentTime - off} ms")
        assertNull(lejos.program)
    }

    @Test
    fun `a tower that is unplugged is gone`() = runTest {
        val line = TestLine(this, lejos)
        val result = async { line.tower.sendProgram(largestImage) }
        delay(20.seconds)
        line.port.unplug()
        assertEquals(lost(TowerError.TowerGone), result.await())
        assertNull(lejos.program)
    }

    @Test
    fun `a port without echo has no tower`() = runTest {
        val line = TestLine(this, lejos, hasEcho = false)
        assertEquals(failed(TowerError.TowerSilent), line.tower.sendProgram(smallImage))
        assertTrue(currentTime < 5_000, "$currentTime ms")
    }

    @Test
    fun `a brick that is off is silent`() = runTest {
        val line = TestLine(this, lejos)
        line.brick.isOn = false
        assertEquals(failed(TowerError.BrickSilent), line.tower.sendProgram(smallImage))
        assertTrue(currentTime < 10_000, "$currentTime ms")
    }

    @Test
    fun `a brick without leJOS is told as such`() = runTest {
        val others = mapOf(SimulatedRom() to null, SimulatedLegoFirmware() to RcxVersion(3, 32), AliveOnly() to null)
        for ((firmware, lego) in others) {
            val start = currentTime
            assertEquals(failed(TowerError.NoLejos(lego)), TestLine(this, firmware).tower.sendProgram(smallImage))
            assertTrue(currentTime - start < 6_000, "$firmware: ${currentTime - start} ms")
        }
    }

    @Test
    fun `a brick that stays deaf to blocks is a bad connection or silent`() = runTest {
        val line = TestLine(this, lejos, faults = LineFaults(seed = 1, loss = 0.3))
        val result = assertIs<TransferResult.Failure>(line.tower.sendProgram(largestImage))
        assertTrue(result.error in setOf(TowerError.BadConnection, TowerError.BrickSilent), "${result.error}")
        assertNull(lejos.program)
    }

    @Test
    fun `a download that is cancelled at any moment leaves no program`() = runTest {
        for (milliseconds in 0..12_000L step 397) cancelAfter(milliseconds)
    }

    private suspend fun TestScope.cancelAfter(milliseconds: Long) {
        val lejos = SimulatedLejos()
        val line = TestLine(this, lejos)
        line.tower.sendProgram(smallImage)
        val image = largestImage.copyOf(1000)
        val job = launch { line.tower.sendProgram(image) }
        delay(milliseconds)
        job.cancelAndJoin()
        delay(10.seconds)
        val left = lejos.program
        assertTrue(
            left == null || left.contentEquals(image) || left.contentEquals(smallImage),
            "after $milliseconds ms there are ${left?.size} bytes",
        )
        assertIs<TransferResult.Success>(line.tower.sendProgram(smallImage), "after $milliseconds ms")
        assertContentEquals(smallImage, lejos.program)
    }
}
