package robotran.legofirmware.run

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.legofirmware.FirmwareProgram
import robotran.legofirmware.assembly.AssemblyResult
import robotran.legofirmware.assembly.assemble
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class LoadingTest {
    @Test
    fun `the brick gets the firmware that the program of the selected slot needs`() {
        val brick =
            RcxBrick(
                listOf(LEJOS, programOf("task 0\n setv 0, 2, 1\n out 1, 2\nendt")),
                messages = BrickMessages.of(Language.ENGLISH),
            )
        assertEquals("9.0 0", brick.state.screen.text)
        assertEquals(null, brick.firmwareState)
        click(brick, BrickButton.PRGM)
        assertEquals("00.00 2", brick.state.screen.text)
        click(brick, BrickButton.RUN)
        brick.tick(20)
        assertEquals(1, (brick.firmwareState as FirmwareState).variables[0])
        assertEquals(RunState.Ended(stopped = false), brick.state.run)
        assertEquals(MotorMode.FORWARD, brick.motor(MotorPort.A).mode)
        repeat(4) { click(brick, BrickButton.PRGM) }
        assertEquals(MotorMode.FLOAT, brick.motor(MotorPort.A).mode)
        assertEquals("9.0 0", brick.state.screen.text)
        click(brick, BrickButton.RUN)
        brick.tick(20)
        assertIs<RunState.Running>(brick.state.run)
    }

    @Test
    fun `a program that is sent runs at once, whatever runs before`() {
        val brick = RcxBrick(listOf(LEJOS), messages = BrickMessages.of(Language.ENGLISH))
        click(brick, BrickButton.RUN)
        brick.tick(20)
        brick.runSnippet(programOf("task 0\n out 2, 2\n wait 2, 100\nendt"))
        brick.tick(20)
        assertEquals(true, brick.state.isSnippet)
        assertEquals(MotorMode.FORWARD, brick.motor(MotorPort.B).mode)
        brick.stopProgram()
        assertEquals(MotorMode.BRAKE, brick.motor(MotorPort.B).mode)
        assertEquals(RunState.Ended(stopped = true), brick.state.run)
        click(brick, BrickButton.ON_OFF)
        brick.tick(100)
        brick.runSnippet(programOf("task 0\n out 1, 2\nendt"))
        brick.tick(20)
        assertEquals(MotorMode.FORWARD, brick.motor(MotorPort.A).mode)
        assertEquals(null, brick.debuggableRun)
    }

    @Test
    fun `why the motors stay on, and why an empty slot starts nothing`() {
        val explanations = Language.entries.map { language ->
            val brick =
                RcxBrick(
                    listOf(programOf("task 0\n out 1, 2\nendt", language)),
                    messages = BrickMessages.of(Language.ENGLISH),
                )
            click(brick, BrickButton.RUN)
            brick.tick(20)
            val motors = brick.state.explanation
            click(brick, BrickButton.PRGM)
            click(brick, BrickButton.RUN)
            motors to brick.state.explanation
        }
        assertEquals(2 * Language.entries.size, explanations.flatMap { it.toList() }.filterNotNull().toSet().size)
        assertEquals(
            "The program is over, but its motors stay on: LEGO's firmware does not stop them. " +
                "A program that is to stop ends with the motors off." to
                "There is no program in slot 2. Choose another one with the Prgm button.",
            explanations[0],
        )
    }

    @Test
    fun `two bricks exchange messages`() {
        val air = InfraredAir()
        val sender =
            RcxBrick(
                listOf(programOf("task 0\n wait 2, 10\n msg 2, 42\nendt")),
                air,
                messages = BrickMessages.of(Language.ENGLISH),
            )
        val receiver =
            RcxBrick(
                listOf(programOf("task 0\nagain: chkl 2, 0, 3, 15, 0, again\n setv 0, 15, 0\nendt")),
                air,
                messages = BrickMessages.of(Language.ENGLISH),
            )
        listOf(sender, receiver).forEach { click(it, BrickButton.RUN) }
        repeat(300) { listOf(sender, receiver).forEach { it.tick() } }
        assertEquals(42, (receiver.firmwareState as FirmwareState).variables[0])
        assertEquals(0, (sender.firmwareState as FirmwareState).message)
    }

    @Test
    fun `a program also runs under another firmware's buttons`() {
        val program = programOf("task 0\n out 1, 2\n wait 2, 10\n setv 0, 2, 7\n wait 2, 10\nendt")
        val alone = object : RcxProgram {
            override val name = "alone"

            override fun start(rom: Rom): ProgramRun = program.start(rom)
        }
        val brick = RcxBrick(listOf(alone), messages = BrickMessages.of(Language.ENGLISH))
        click(brick, BrickButton.RUN)
        brick.tick(150)
        assertEquals(MotorMode.FORWARD, brick.motor(MotorPort.A).mode)
        assertEquals(7, assertIs<LegoFirmwareRun>(brick.debuggableRun).firmware.variables[0])
        brick.tick(100)
        assertEquals(RunState.Ended(stopped = false), brick.state.run)
    }

    private fun RcxBrick.tick(milliseconds: Int) = repeat(milliseconds) { tick() }

    private fun click(brick: RcxBrick, button: BrickButton) {
        brick.press(button)
        brick.release(button)
    }

    private fun programOf(source: String, language: Language = Language.ENGLISH): FirmwareProgram {
        val result = assertIs<AssemblyResult.Success>(assemble(source, Language.ENGLISH))
        return FirmwareProgram("test", result.image, result.lines, language)
    }

    private companion object {
        /** A program for leJOS's firmware that never ends. */
        val LEJOS = object : RcxProgram {
            override val name = "endless"

            override fun start(rom: Rom): ProgramRun = object : ProgramRun {
                override val sourceLine = 1

                override fun resume(steps: Int) = ProgramStatus.Running
            }
        }
    }
}
