package robotran.workshop.send

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.runTest
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.ImageBuildResult
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.projects.PENBOT_TARGET
import robotran.tower.TowerError
import robotran.tower.port.OpenedTower
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPorts
import robotran.tower.simulated.LineFaults
import robotran.tower.simulated.SimulatedBrick
import robotran.tower.simulated.SimulatedLegoFirmware
import robotran.tower.simulated.SimulatedLejos
import robotran.tower.simulated.SimulatedRom
import robotran.tower.simulated.SimulatedTower
import robotran.tower.simulated.brickAfter
import robotran.tower.simulated.programIn
import robotran.workshop.Workshop
import robotran.workshop.documents.MemoryFilePicker
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.SendError
import robotran.workshop.state.SendStep
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.time.Duration.Companion.minutes

/** From the text of a program to the memory of a simulated brick, with everything between. */
@OptIn(ExperimentalCoroutinesApi::class)
class SimulatedBrickTest {
    private val files = MemoryFilePicker()

    @Test
    fun `a program in Robolang and one in Java arrive in the brick as the compiler builds them`() = runTest {
        val brick = SimulatedBrick(SimulatedLejos())
        val workshop = workshopBefore(brick)
        for ((program, source) in PROGRAMS) {
            workshop.handle(ProgramEvent.ProgramAdded(program))
            assertSent(send(workshop))
            val built = ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH).buildImage(listOf(source))
            assertContentEquals(assertIs<ImageBuildResult.Success>(built).image.bytes, brick.program)
            workshop.handle(SendEvent.Cancelled)
        }
        workshop.close()
    }

    @Test
    fun `with 5 percent of all bytes lost the program arrives whole`() = runTest(timeout = 3.minutes) {
        val brick = SimulatedBrick(SimulatedLejos())
        val workshop = workshopBefore(brick, LineFaults(seed = 5, loss = 0.05))
        assertSent(send(workshop))
        val clear = SimulatedBrick(SimulatedLejos())
        val other = workshopBefore(clear)
        assertSent(send(other))
        assertContentEquals(clear.program, brick.program)
        workshop.close()
        other.close()
    }

    @Test
    fun `a brick with LEGO's firmware gets the firmware that the pupil chooses, then the program`() = runTest {
        val brick = SimulatedBrick(SimulatedLegoFirmware())
        val workshop = workshopBefore(brick)
        assertIs<SendStep.NeedsFirmware>(send(workshop))
        files.chosen = listOf(OpenedFile("lejos.srec", firmwareFile()))
        workshop.handle(SendEvent.FirmwareFileRequested)
        testScheduler.advanceTimeBy(STEP_MILLISECONDS)
        workshop.handle(SendEvent.FirmwareConfirmed)
        assertSent(endOf(workshop))
        assertEquals(0xCA.toByte(), brick.program?.first())
        workshop.close()
    }

    @Test
    fun `a program in NQC gets into the slot that the pupil chooses, and runs there`() = runTest {
        val lego = SimulatedLegoFirmware()
        val workshop = workshopBefore(SimulatedBrick(lego), LineFaults(seed = 3, loss = 0.01))
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("drive.nqc", NQC)))
        assertIs<SendStep.ChoosingSlot>(send(workshop))
        workshop.handle(SendEvent.SlotChosen(4))
        assertEquals(4, assertIs<SendStep.Done>(endOf(workshop)).slot)
        assertEquals(MotorMode.FORWARD, brickAfter(lego.programIn(slot = 4), 500).motor(MotorPort.A).mode)
        workshop.close()
    }

    @Test
    fun `a brick with leJOS gets LEGO's firmware from a file, then the program in NQC`() = runTest {
        val lego = SimulatedLegoFirmware()
        val brick = SimulatedBrick(SimulatedRom { lego })
        val workshop = workshopBefore(brick)
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("drive.nqc", NQC)))
        assertEquals(TowerError.NoLegoFirmware, assertIs<SendStep.NeedsFirmware>(send(workshop)).why)
        files.chosen = listOf(OpenedFile("firm0328.lgo", firmwareFile("FIRM0328.LGO")))
        workshop.handle(SendEvent.FirmwareFileRequested)
        testScheduler.advanceTimeBy(STEP_MILLISECONDS)
        workshop.handle(SendEvent.FirmwareConfirmed)
        assertIs<SendStep.ChoosingSlot>(endOf(workshop))
        workshop.handle(SendEvent.SlotChosen(1))
        assertSent(endOf(workshop))
        assertEquals(setOf("1 task 0"), lego.parts.keys)
        workshop.close()
    }

    @Test
    fun `a cancelled transfer leaves no program that Run could start`() = runTest {
        val brick = SimulatedBrick(SimulatedLejos())
        val workshop = workshopBefore(brick)
        assertSent(send(workshop))
        workshop.handle(SendEvent.Cancelled)
        workshop.handle(SendEvent.Requested)
        while ((workshop.state.send?.step as? SendStep.Sending)?.progress?.confirmedBlocks != 2) {
            testScheduler.advanceTimeBy(STEP_MILLISECONDS)
        }
        workshop.handle(SendEvent.Cancelled)
        testScheduler.advanceTimeBy(STEP_MILLISECONDS)
        assertIs<SendStep.Cancelled>(workshop.state.send?.step)
        assertNull(brick.program)
        workshop.close()
    }

    @Test
    fun `a brick that is off is told`() = runTest {
        val brick = SimulatedBrick(SimulatedLejos()).apply { isOn = false }
        val workshop = workshopBefore(brick)
        assertEquals(SendStep.Failed(SendError.OfTower(TowerError.BrickSilent)), send(workshop))
        brick.isOn = true
        workshop.handle(SendEvent.Retried)
        assertSent(endOf(workshop))
        workshop.close()
    }

    private val SimulatedBrick.program: ByteArray? get() = (firmware as SimulatedLejos).program

    private fun assertSent(step: SendStep?) = assertIs<SendStep.Done>(step, "$step")

    private suspend fun TestScope.workshopBefore(brick: SimulatedBrick, faults: LineFaults = LineFaults()): Workshop =
        openWorkshop(
            platform = MemoryPlatform(files = files, towers = OneTower(backgroundScope, brick, faults)),
            scope = backgroundScope,
        )

    private fun TestScope.send(workshop: Workshop): SendStep? {
        workshop.handle(SendEvent.Requested)
        return endOf(workshop)
    }

    /** The step in which nothing is under way any more. */
    private fun TestScope.endOf(workshop: Workshop): SendStep? {
        do testScheduler.advanceTimeBy(STEP_MILLISECONDS) while (workshop.state.send?.step?.isBusy == true)
        return workshop.state.send?.step
    }

    private class OneTower(
        private val scope: CoroutineScope,
        private val brick: SimulatedBrick,
        private val faults: LineFaults,
    ) : TowerPorts {
        override val kinds: Set<TowerKind> = setOf(TowerKind.SERIAL)

        override suspend fun available(): List<TowerDevice> = listOf(SERIAL_TOWER)

        override suspend fun choose(kind: TowerKind): TowerDevice = SERIAL_TOWER

        override suspend fun open(device: TowerDevice): OpenedTower =
            OpenedTower.Success(SimulatedTower(scope, brick, faults = faults))
    }

    private companion object {
        const val STEP_MILLISECONDS = 200L
        const val ROBOLANG = "forward 20\nbeep\n"
        const val NQC = "task main() { OnFwd(OUT_A); Wait(100); Off(OUT_A); }\n"
        const val JAVA = "import josx.platform.rcx.*;\n" +
            "public class Beeper { public static void main(String[] args) { Sound.beep(); } }\n"

        val PROGRAMS = listOf(
            Program.of("beeper.robo", ROBOLANG) to Program("beeper.robo", ProgramLanguage.ROBOLANG, ROBOLANG),
            Program.of("Beeper.java", JAVA) to
                Program("Beeper.java", ProgramLanguage.JAVA, JAVA),
        )
    }
}
