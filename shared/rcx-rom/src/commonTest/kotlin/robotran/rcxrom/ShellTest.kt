package robotran.rcxrom

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.program.ProgramStatus
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.sound.SystemSounds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class ShellTest {
    private val endless = endlessProgram()
    private val brick = RcxBrick(listOf(endless), messages = BrickMessages.of(Language.ENGLISH))

    @Test
    fun `a brick begins switched on and shows its volts and the standing man`() {
        assertTrue(brick.state.poweredOn)
        assertEquals("9.0 0", brick.state.glass.text)
        assertEquals(setOf(LcdIcon.STANDING_MAN, LcdIcon.POINT_1), brick.state.glass.litIcons)
        assertEquals(RunState.Idle, brick.state.run)
        assertEquals(listOf(MotorMode.FLOAT, MotorMode.FLOAT, MotorMode.FLOAT), brick.state.motors.map { it.mode })
        brick.tick(1_000)
        assertEquals(listOf(150, 150), brick.tones().map { it.durationMilliseconds })
    }

    @Test
    fun `a brick without programs shows no man and cannot run`() {
        val empty = RcxBrick(emptyList(), messages = BrickMessages.of(Language.ENGLISH))
        assertEquals("9.0 0", empty.state.glass.text)
        assertFalse(empty.state.glass.isLit(LcdIcon.STANDING_MAN))
        empty.push(BrickButton.PRGM)
        empty.push(BrickButton.RUN)
        assertEquals(RunState.Idle, empty.state.run)
        assertEquals(0, empty.state.selectedSlot)
    }

    @Test
    fun `Run starts the program when it is let go`() {
        brick.press(BrickButton.RUN)
        assertEquals(RunState.Idle, brick.state.run)
        assertEquals(setOf(BrickButton.RUN), brick.state.pressed)
        brick.release(BrickButton.RUN)
        assertEquals(RunState.Running(sourceLine = 0), brick.state.run)
        assertTrue(brick.state.glass.isLit(LcdIcon.WALKING_MAN))
        assertFalse(brick.state.glass.isLit(LcdIcon.STANDING_MAN))
    }

    @Test
    fun `Prgm beeps when pressed and chooses the next program when let go`() {
        val three = RcxBrick(List(3) { endlessProgram() }, messages = BrickMessages.of(Language.ENGLISH))
        val shown = List(4) {
            three.press(BrickButton.PRGM)
            assertEquals("queue system sound 0 (beep)", three.log.entries.last().meaning)
            three.release(BrickButton.PRGM)
            three.state.selectedSlot to three.state.glass.text
        }
        assertEquals(listOf(1 to "9.0 1", 2 to "9.0 2", 0 to "9.0 0", 1 to "9.0 1"), shown)
    }

    @Test
    fun `Run starts the program that was chosen`() {
        val programs = List(3) { endlessProgram() }
        val three = RcxBrick(programs, messages = BrickMessages.of(Language.ENGLISH))
        three.push(BrickButton.PRGM)
        three.push(BrickButton.RUN)
        assertEquals(listOf(0, 1, 0), programs.map { it.starts })
    }

    @Test
    fun `while a program runs the other buttons are its own`() {
        brick.push(BrickButton.RUN)
        for (button in listOf(BrickButton.RUN, BrickButton.PRGM, BrickButton.VIEW)) brick.push(button)
        assertEquals(1, endless.starts)
        assertEquals(0, brick.state.selectedSlot)
        assertEquals(RunState.Running(sourceLine = 0), brick.state.run)
    }

    @Test
    fun `View does nothing in the shell`() {
        val calls = brick.log.total
        brick.push(BrickButton.VIEW)
        assertEquals(calls, brick.log.total)
    }

    @Test
    fun `a button pressed during a run and let go after it does nothing`() {
        brick.push(BrickButton.RUN)
        brick.press(BrickButton.RUN)
        brick.stopProgram()
        brick.release(BrickButton.RUN)
        assertEquals(RunState.Ended(stopped = true), brick.state.run)
        assertEquals(1, endless.starts)
    }

    @Test
    fun `On-Off switches the brick off when let go and on again`() {
        brick.press(BrickButton.ON_OFF)
        assertTrue(brick.state.poweredOn)
        brick.release(BrickButton.ON_OFF)
        assertFalse(brick.state.poweredOn)
        assertEquals(LcdGlass.BLANK, brick.state.glass)
        brick.push(BrickButton.RUN)
        brick.push(BrickButton.PRGM)
        assertEquals(0, endless.starts)
        brick.push(BrickButton.ON_OFF)
        assertTrue(brick.state.poweredOn)
        assertEquals("9.0 0", brick.state.glass.text)
    }

    @Test
    fun `switching off beeps once and the beep is still heard`() {
        brick.push(BrickButton.ON_OFF)
        brick.tick(1_000)
        assertEquals(listOf(10), brick.tones().map { it.durationMilliseconds })
        assertEquals(1_000L, brick.state.milliseconds)
    }

    @Test
    fun `switching off forgets the program that runs and lets the motors go`() {
        val driving = brickThatDrives()
        driving.push(BrickButton.ON_OFF)
        driving.tick()
        assertEquals(RunState.Idle, driving.state.run)
        assertTrue(driving.kind.motorPorts.all { driving.motorOutput(it) == MotorMode.FLOAT })
        driving.push(BrickButton.ON_OFF)
        assertEquals(RunState.Idle, driving.state.run)
    }

    @Test
    fun `On-Off with Run held down ends the program and leaves the brick on`() {
        val driving = brickThatDrives()
        driving.press(BrickButton.RUN)
        driving.push(BrickButton.ON_OFF)
        driving.release(BrickButton.RUN)
        assertTrue(driving.state.poweredOn)
        assertEquals(RunState.Ended(stopped = true), driving.state.run)
        assertEquals(List(3) { MotorMode.BRAKE to 0 }, driving.state.motors.map { it.mode to it.power })
    }

    @Test
    fun `the order in which On-Off and Run go down and up does not matter`() {
        brick.push(BrickButton.RUN)
        brick.press(BrickButton.ON_OFF)
        brick.push(BrickButton.RUN)
        brick.release(BrickButton.ON_OFF)
        assertTrue(brick.state.poweredOn)
        assertEquals(RunState.Ended(stopped = true), brick.state.run)
        assertEquals(1, endless.starts)
    }

    @Test
    fun `holding Run in the shell does not keep On-Off from switching off`() {
        brick.press(BrickButton.RUN)
        brick.push(BrickButton.ON_OFF)
        brick.release(BrickButton.RUN)
        assertFalse(brick.state.poweredOn)
        assertEquals(0, endless.starts)
    }

    @Test
    fun `the stop beside the world ends the program like its own end`() {
        val driving = brickThatDrives()
        driving.stopProgram()
        assertEquals(RunState.Ended(stopped = true), driving.state.run)
        assertTrue(driving.state.motors.all { it.mode == MotorMode.BRAKE })
        assertTrue(driving.state.glass.isLit(LcdIcon.STANDING_MAN))
    }

    @Test
    fun `stop does nothing when no program runs`() {
        val calls = brick.log.total
        brick.stopProgram()
        assertEquals(RunState.Idle, brick.state.run)
        assertEquals(calls, brick.log.total)
    }

    @Test
    fun `a button that is down already is not pressed again`() {
        brick.press(BrickButton.PRGM)
        val calls = brick.log.total
        brick.press(BrickButton.PRGM)
        brick.release(BrickButton.RUN)
        assertEquals(calls, brick.log.total)
    }

    @Test
    fun `the sounds of the firmware are told from those that a program asks for`() {
        val beeping =
            ScriptedProgram(listOf(calling(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, SystemSounds.TWO_BEEPS)))
        val brick = RcxBrick(listOf(beeping), messages = BrickMessages.of(Language.ENGLISH))
        brick.push(BrickButton.RUN)
        brick.tick(2_000)
        assertEquals(listOf(true, true, false, false, true, true), brick.tones().map { it.isFirmware })
    }

    private fun brickThatDrives(): RcxBrick {
        val program =
            ScriptedProgram(
                listOf(calling(RomAddress.CONTROL_MOTOR, 0x2000, 1, 7)),
                statusAtEnd = ProgramStatus.Running,
            )
        return RcxBrick(listOf(program), messages = BrickMessages.of(Language.ENGLISH)).apply {
            push(BrickButton.RUN)
            tick(2)
            assertEquals(MotorMode.FORWARD, motorOutput(MotorPort.A))
        }
    }
}
