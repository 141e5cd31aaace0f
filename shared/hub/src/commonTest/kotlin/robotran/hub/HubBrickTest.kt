package robotran.hub

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.log.CallOutcome
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramStatus
import robotran.brick.sensors.ExpectedSensor
import robotran.brick.sensors.SensorKind
import robotran.brick.state.RunState
import robotran.hub.model.HubButton
import robotran.hub.model.HubColor
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubModel
import robotran.hub.model.HubPort
import robotran.hub.program.Hub
import robotran.hub.program.HubCall
import robotran.hub.program.HubError
import robotran.hub.program.HubNative
import robotran.hub.program.HubReading
import robotran.hub.program.LightMode
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class HubBrickTest {
    private val drives: (Hub) -> ProgramStatus = { hub ->
        hub.call(HubCall.device(HubDeviceKind.MOTOR, HubPort.A), TEST_LINE)
        hub.call(HubCall.on(HubNative.MOTOR_RUN, HubPort.A, 500), TEST_LINE)
        ProgramStatus.Running
    }
    private val endless = ScriptedProgram(ProgramStatus.Running, "endless", actions = arrayOf(drives))
    private val bench =
        HubBench(programs = listOf(endless, ScriptedProgram(name = "driven", actions = arrayOf(drives, ::waits))))
    private val brick = bench.brick

    @Test
    fun `a short press of the middle button starts a program, the next one stops it and its motors roll`() {
        push(BrickButton.ENTER)
        assertTrue(brick.state.run is RunState.Running)
        bench.wait(500)
        assertEquals(MotorMode.FORWARD, brick.motor(MotorPort.A).mode)
        push(BrickButton.ENTER)
        assertEquals(RunState.Ended(stopped = true), brick.state.run)
        assertEquals(MotorMode.FLOAT, brick.motor(MotorPort.A).mode)
        assertEquals("firmware", brick.log.entries.last().text.substringAfterLast("; "))
        assertEquals(null, brick.state.explanation)
    }

    @Test
    fun `left and right choose another program, whose number the lights show`() {
        push(BrickButton.RIGHT)
        assertEquals(1 to "2", brick.state.selectedSlot to brick.state.screen.shown)
        push(BrickButton.RIGHT)
        push(BrickButton.LEFT)
        assertEquals(0, brick.state.selectedSlot)
    }

    @Test
    fun `a program that ends with motors running is told why the robot stops`() {
        push(BrickButton.RIGHT)
        push(BrickButton.ENTER)
        bench.wait(300)
        assertEquals(RunState.Ended(stopped = false), brick.state.run)
        assertTrue(brick.state.explanation.orEmpty().startsWith("The program has come to its end"))
    }

    @Test
    fun `a program that ends when its move has ended needs no explanation, though the motor is still held`() {
        val moves: (Hub) -> ProgramStatus = { hub ->
            hub.call(HubCall.device(HubDeviceKind.MOTOR, HubPort.A), TEST_LINE)
            hub.call(HubCall.on(HubNative.MOTOR_RUN_ANGLE, HubPort.A, 500, 90, 0), TEST_LINE)
            ProgramStatus.Waiting(hub.milliseconds + 2_000)
        }
        brick.runSnippet(ScriptedProgram(name = "moved", actions = arrayOf(moves)))
        bench.wait(1_900)
        assertTrue(brick.state.run is RunState.Running)
        bench.wait(200)
        assertEquals(RunState.Ended(stopped = false), brick.state.run)
        assertEquals(null, brick.state.explanation)
    }

    @Test
    fun `a program can take another button for stopping, and then sees the middle one`() {
        push(BrickButton.ENTER)
        assertEquals(null, bench.call(HubNative.SET_STOP_BUTTON, HubButton.BLUETOOTH.ordinal))
        brick.press(BrickButton.ENTER)
        brick.press(BrickButton.LEFT)
        assertEquals(setOf(HubButton.CENTER, HubButton.LEFT), bench.hub.pressed)
        assertTrue(brick.state.run is RunState.Running)
        brick.press(BrickButton.BLUETOOTH)
        assertEquals(RunState.Ended(stopped = true), brick.state.run)
        assertEquals(HubError.INVALID_ARGUMENT, bench.call(HubNative.SET_STOP_BUTTON, HubButton.UP.ordinal))
    }

    @Test
    fun `buttons are seen as long as they are down, as with Pybricks`() {
        val known = recorded("27-buttons").map { line -> line.substringBefore(' ').toInt() to line.count { it == 'B' } }
        val all = listOf(BrickButton.LEFT, BrickButton.RIGHT)
        bench.call(HubNative.SET_STOP_BUTTON, -1)
        val seen = known.take(3).mapIndexed { count, (time, _) ->
            all.take(count).forEach(brick::press)
            time to bench.hub.pressed.size
        }
        assertEquals(known.take(3), seen)
    }

    @Test
    fun `the back button of an EV3 stops its program`() {
        val program = ScriptedProgram(ProgramStatus.Running, "endless", HubModel.EV3, drives)
        val ev3 = HubBench(HubModel.EV3, programs = listOf(program))
        ev3.brick.press(BrickButton.ENTER)
        ev3.brick.release(BrickButton.ENTER)
        ev3.brick.press(BrickButton.ENTER)
        assertTrue(ev3.brick.state.run is RunState.Running)
        ev3.brick.press(BrickButton.ESCAPE)
        assertEquals(RunState.Ended(stopped = true), ev3.brick.state.run)
        assertEquals("> endless", ev3.brick.state.screen.lines.first())
    }

    @Test
    fun `a program that fails leaves its motors rolling and says why`() {
        val failing =
            ScriptedProgram(
                ProgramStatus.Failed(ProgramFailure("There is nothing to divide by.", 12)),
                "f",
                actions = arrayOf(drives),
            )
        brick.runSnippet(failing)
        bench.wait(10)
        assertTrue(brick.state.run is RunState.Failed)
        assertTrue(brick.state.isSnippet)
        assertTrue(brick.state.explanation.orEmpty().contains("Line 12: There is nothing to divide by."))
        assertEquals(MotorMode.FLOAT, brick.motor(MotorPort.A).mode)
        brick.stopProgram()
        assertEquals(null, brick.state.explanation)
    }

    @Test
    fun `what is not plugged in cannot be made, nor twice, nor as something else`() {
        brick.plugSensor(HubPort.F, HubDeviceKind.ULTRASONIC_SENSOR)
        assertEquals(HubError.WRONG_DEVICE, bench.make(HubPort.F))
        assertEquals(null, bench.make(HubPort.D))
        assertEquals(HubError.BUSY, bench.make(HubPort.D))
        assertEquals(HubError.INVALID_ARGUMENT, bench.make(HubPort.S1))
        brick.plugMotor(MotorPort.E, null)
        assertEquals(HubError.NO_DEVICE, bench.make(HubPort.E))
        assertEquals(CallOutcome.WRONG_ARGUMENTS, brick.log.entries.last().outcome)
        assertEquals("0 device Motor E ; refused: OSError: [Errno 19] ENODEV ; 7", brick.log.entries.last().text)
    }

    @Test
    fun `a port shows the brightness that the program asked for last`() {
        brick.plugMotor(MotorPort.D, null)
        brick.plugSensor(HubPort.D, HubDeviceKind.COLOR_SENSOR, LightMode.AMBIENT)
        brick.measure(HubPort.D, HubReading.Light(1024, 1024, 1024, ambient = 30))

        fun shown() = brick.state.ports[3].value
        assertEquals(30, shown())
        assertEquals(100, bench.hub.brightness(HubPort.D, LightMode.REFLECTION))
        assertEquals(100, shown())
        assertEquals(30, bench.hub.brightness(HubPort.D, LightMode.AMBIENT))
        assertEquals(30, shown())
        assertEquals(null, bench.hub.brightness(HubPort.E, LightMode.AMBIENT))
    }

    @Test
    fun `sensors are read on the scales of Pybricks`() {
        for ((port, kind) in listOf(HubPort.D to HubDeviceKind.COLOR_SENSOR, HubPort.E to HubDeviceKind.FORCE_SENSOR)) {
            brick.plugMotor(checkNotNull(port.motorPort), null)
            brick.plugSensor(port, kind)
            assertEquals(null, bench.hub.call(HubCall.device(kind, port), TEST_LINE))
        }
        brick.measure(HubPort.D, HubReading.Light(1024, 1024, 1024))
        assertEquals(100, (bench.hub.sensor(HubPort.D) as HubReading.Light).reflection)
        assertEquals(HubColor.WHITE, bench.hub.color(HubPort.D))
        brick.measure(HubPort.D, HubReading.Light(600, 60, 50))
        assertEquals(HubColor.RED, bench.hub.color(HubPort.D))
        brick.measure(HubPort.D, HubReading.Light(60, 60, 60))
        assertEquals(HubColor.NONE, bench.hub.color(HubPort.D))
        val others = listOf(HubColor.BLACK, HubColor.WHITE)
        bench.hub.call(HubCall.detectableColors(HubPort.D, others), TEST_LINE)
        assertEquals(HubColor.BLACK, bench.hub.color(HubPort.D))
        brick.measure(HubPort.E, HubReading.Force(5))
        val force = bench.hub.sensor(HubPort.E) as HubReading.Force
        assertTrue(force.isTouched)
        assertFalse(force.isPressed)
        assertEquals(listOf(4, 5), brick.expectedSensors.map { it.port })
        assertEquals(ExpectedSensor(5, SensorKind.TOUCH, TEST_LINE, null), brick.expectedSensors.last())
        assertTrue(brick.state.inputs[4].isPressed)
    }

    @Test
    fun `the heading begins at 0 with each program and grows to the right`() {
        brick.setTurned(40.0)
        push(BrickButton.ENTER)
        brick.setTurned(70.0)
        assertEquals(30.0, bench.hub.heading)
        assertEquals(null, HubBench(HubModel.EV3).hub.heading)
    }

    @Test
    fun `the same program makes the same trace`() {
        val traces = List(2) {
            val other = HubBench(programs = listOf(endless))
            other.brick.press(BrickButton.ENTER)
            other.wait(700)
            other.brick.stopProgram()
            buildList { other.brick.log.entries.forEach { it.identify(::add) } }
        }
        assertEquals(traces[0], traces[1])
        assertTrue(traces[0].size > 10)
    }

    private fun push(button: BrickButton) {
        brick.press(button)
        bench.wait(50)
        brick.release(button)
        bench.wait(50)
    }

    private fun waits(hub: Hub): ProgramStatus = ProgramStatus.Waiting(hub.milliseconds + 200)
}
