package robotran.tower.rcx

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.legofirmware.assembly.AssemblyResult
import robotran.legofirmware.assembly.assemble
import robotran.legofirmware.run.FirmwareState
import robotran.tower.TransferResult
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.brickAfter
import robotran.tower.simulated.programIn
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** What arrived in a brick runs on the virtual one. */
class ReceivedProgramsTest {
    private val image = assertIs<AssemblyResult.Success>(assemble(PROGRAM, language = Language.ENGLISH)).image

    @Test
    fun `a program of tasks and a subroutine runs after its way over a bad line`() = runTest {
        for (seed in 1..4) {
            val lego = SimulatedLegoFirmware()
            val line = TestLine(this, lego, faults = LineFaults(seed, loss = 0.02, doubled = 0.01, corrupted = 0.01))
            assertIs<TransferResult.Success>(line.tower.sendLegoProgram(2, image), "seed $seed")
            val received = lego.programIn(slot = 2)
            assertEquals(image.chunks.sortedBy { it.id }, received.image.chunks.sortedBy { it.id })
            val brick = brickAfter(received, milliseconds = 700)
            assertEquals(MotorMode.FORWARD, brick.motor(MotorPort.A).mode)
            assertEquals(listOf(42, 7), assertIs<FirmwareState>(brick.firmwareState).variables.take(2))
            assertEquals(RunState.Ended(stopped = false), brick.state.run)
        }
    }

    private companion object {
        const val PROGRAM = """
            task 0
            start 1
            setv 0, 2, 40
            calls 3
            wait 2, 50
            endt
            task 1
            setv 1, 2, 7
            out 1, 2
            endt
            sub 3
            sumv 0, 2, 2
            ends
        """
    }
}
