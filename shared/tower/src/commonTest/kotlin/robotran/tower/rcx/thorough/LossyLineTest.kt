package robotran.tower.rcx.thorough

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.currentTime
import kotlinx.coroutines.test.runTest
import robotran.tower.TransferResult
import robotran.tower.largestImage
import robotran.tower.rcx.TestLine
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedLejos
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

@OptIn(ExperimentalCoroutinesApi::class)
class LossyLineTest {
    @Test
    fun `the largest example arrives though 5 percent of all bytes are lost`() = runTest(timeout = 10.minutes) {
        val lejos = SimulatedLejos()
        val line = TestLine(this, lejos, faults = LineFaults(seed = 22, loss = 0.05))
        assertIs<TransferResult.Success>(line.tower.sendProgram(largestImage))
        assertContentEquals(largestImage, lejos.program)
        assertTrue(currentTime < 3_600_000, "$currentTime ms")
    }
}
