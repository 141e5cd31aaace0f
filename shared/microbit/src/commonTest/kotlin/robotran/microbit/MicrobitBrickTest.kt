package robotran.microbit

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.kind.BuggyKind
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramStatus
import robotran.brick.state.RunState
import robotran.microbit.buggy.Buggy
import robotran.microbit.buggy.MicrobitSensor
import robotran.microbit.model.MicrobitButton
import robotran.microbit.model.MicrobitModel
import robotran.microbit.program.Microbit
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitNative
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

class MicrobitBrickTest {
    private val stop = listOf("i2c 0x10 01 02 00 00", "i2c 0x10 02 02 00 00")

    private fun drive(board: Microbit): ProgramStatus {
        for (call in Buggy.of(BuggyKind.CUTEBOT).wheels.calls(45, 45)) board.call(call, sourceLine = 1)
        return ProgramStatus.Waiting(board.milliseconds + 100)
    }

    @Test
    fun `an arrow points to button A, which starts the program`() {
        val bench = MicrobitBench(ScriptedProgram(actions = arrayOf(::drive)))
        assertEquals("..#..\n.#...\n#####\n.#...\n..#..\n", bench.brick.state.screen.toArt())
        bench.tap(BrickButton.RIGHT)
        assertEquals(RunState.Idle, bench.brick.state.run)
        bench.tap(BrickButton.ENTER)
        bench.tick(1)
        assertIs<RunState.Running>(bench.brick.state.run)
        assertEquals("", bench.brick.state.screen.toArt().filter { it == '#' })
    }

    @Test
    fun `the wheels are stopped before a program and after it, and so is the sound`() {
        val bench = MicrobitBench(ScriptedProgram(actions = arrayOf(::drive)))
        bench.tap(BrickButton.ENTER)
        bench.tick(50)
        assertEquals(MotorMode.FORWARD to 45, bench.brick.motor(MotorPort.A).let { it.mode to it.power })
        bench.tick(100)
        assertEquals(stop + listOf("i2c 0x10 01 02 2d 00", "i2c 0x10 02 02 2d 00") + stop + "music stop", bench.calls)
        assertEquals(RunState.Ended(stopped = false), bench.brick.state.run)
        assertEquals(MotorMode.BRAKE, bench.brick.motor(MotorPort.C).mode)
        assertNotNull(bench.brick.state.explanation)
        assertEquals(listOf(0, 0, 1, 1, 0, 0, 0), bench.brick.log.entries.map { it.sourceLine })
    }

    @Test
    fun `they are stopped after an error, and when somebody ends the program`() {
        val failure = ProgramFailure("It went wrong.", 3)
        val failing = MicrobitBench(
            ScriptedProgram(statusAtEnd = ProgramStatus.Failed(failure), actions = arrayOf(::drive)),
        )
        failing.tap(BrickButton.ENTER)
        failing.tick(200)
        assertEquals(stop + "music stop", failing.calls.takeLast(3))
        assertEquals(RunState.Failed(failure), failing.brick.state.run)
        assertTrue("It went wrong." in assertNotNull(failing.brick.state.explanation))
        val stopped = MicrobitBench(ScriptedProgram(actions = arrayOf(::drive)))
        stopped.tap(BrickButton.ENTER)
        stopped.tick(50)
        stopped.brick.stopProgram()
        assertEquals(stop + "music stop", stopped.calls.takeLast(3))
        assertEquals(RunState.Ended(stopped = true), stopped.brick.state.run)
        stopped.tick(200)
        assertEquals(MotorMode.BRAKE, stopped.brick.motor(MotorPort.A).mode)
    }

    @Test
    fun `the press that starts a program is not for it`() {
        val seen = mutableListOf<Pair<Boolean, Boolean>>()
        val look = { board: Microbit ->
            seen += board.isPressed(MicrobitButton.A) to board.isPressed(MicrobitButton.B)
            ProgramStatus.Waiting(board.milliseconds + 10)
        }
        val bench = MicrobitBench(ScriptedProgram(actions = arrayOf(look, look, look)))
        bench.brick.press(BrickButton.ENTER)
        bench.tick(5)
        bench.brick.release(BrickButton.ENTER)
        bench.brick.press(BrickButton.ENTER)
        bench.tick(10)
        bench.brick.press(BrickButton.RIGHT)
        bench.tick(10)
        assertEquals(listOf(false to false, true to false, true to true), seen)
    }

    @Test
    fun `a V1 has no logo, and needs a buzzer for its sounds`() {
        val beep = { board: Microbit ->
            board.call(MicrobitCall.of(MicrobitNative.MUSIC_PITCH, 880, 100), 1)
            ProgramStatus.Waiting(board.milliseconds + 50)
        }

        fun sounds(model: MicrobitModel, buggy: BuggyKind): Boolean {
            val bench = MicrobitBench(ScriptedProgram(model, actions = arrayOf(beep)), model = model, buggy = buggy)
            bench.tap(BrickButton.ENTER)
            bench.tick(20)
            return bench.brick.isSounding
        }
        assertTrue(sounds(MicrobitModel.V2, BuggyKind.CUTEBOT_PRO))
        assertTrue(sounds(MicrobitModel.V1, BuggyKind.CUTEBOT))
        assertFalse(sounds(MicrobitModel.V1, BuggyKind.CUTEBOT_PRO))
        val old = MicrobitBench(model = MicrobitModel.V1)
        old.brick.press(BrickButton.ESCAPE)
        assertEquals(emptySet(), old.brick.state.pressed)
    }

    @Test
    fun `a line sensor has a threshold, and changes its mind only beyond it`() {
        val bench = MicrobitBench()
        bench.brick.plug(Buggy.of(BuggyKind.CUTEBOT).sensors)
        val dark = listOf(100, 44, 41, 44, 47, 48, 44).map { percent ->
            bench.brick.measureLine(0, percent)
            bench.brick.board.isDark(0)
        }
        assertEquals(listOf(false, false, true, true, true, false, false), dark)
        bench.brick.measureLine(1, 5)
        bench.brick.measureDistance(17)
        assertEquals(listOf(100, 0, 17, 0), bench.brick.state.inputs.map { it.value })
        assertEquals(MicrobitSensor.Sonar, bench.brick.state.ports[2].sensor)
    }

    @Test
    fun `the pen is down when its servo is`() {
        val servo = checkNotNull(Buggy.of(BuggyKind.CUTEBOT).pen)
        val bench = MicrobitBench()
        assertEquals(MotorMode.FLOAT, bench.brick.motor(MotorPort.B).mode)
        bench.brick.board.call(servo.turnTo(45), 1)
        assertEquals(MotorMode.FORWARD, bench.brick.motor(MotorPort.B).mode)
        bench.brick.board.call(servo.turnTo(90), 1)
        assertEquals(MotorMode.BACKWARD, bench.brick.motor(MotorPort.B).mode)
        assertEquals("turn the servo of the pen to 90 degrees", bench.brick.log.entries.last().meaning)
    }

    @Test
    fun `of several programs button B chooses the next`() {
        val bench = MicrobitBench(ScriptedProgram(), null)
        assertEquals("1", bench.brick.state.screen.shown)
        bench.tap(BrickButton.RIGHT)
        assertEquals(1 to "2", bench.brick.state.let { it.selectedSlot to it.screen.shown })
        bench.tap(BrickButton.ENTER)
        assertEquals(RunState.Idle, bench.brick.state.run)
        bench.tap(BrickButton.RIGHT)
        assertEquals(0, bench.brick.state.selectedSlot)
    }
}
