package robotran.hub

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.hub.model.HubMotorKind
import robotran.hub.model.HubPort
import robotran.hub.program.HubNative
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Motors against what Pybricks' own virtual hub did: times to 20 ms, angles to 2 degrees. */
class MotorControlTest {
    private val bench = HubBench().apply { make(HubPort.B) }
    private val motor = bench.motor(HubPort.B)

    @Test
    fun `moves by angles and to targets take as long and end where they do with Pybricks`() {
        val lines = recorded("12-motor-moves").filter {
            it.startsWith("run_angle") || it.startsWith("run_target 500 0")
        }
        val told = lines.map { line ->
            val (_, speed, angle, milliseconds, end) = line.split(' ')
            val native = if (line.startsWith("run_angle")) HubNative.MOTOR_RUN_ANGLE else HubNative.MOTOR_RUN_TARGET
            bench.on(native, HubPort.B, speed.toInt(), angle.toInt(), 0)
            val took = bench.until { motor.isDone }
            val isNear = abs(took - milliseconds.toInt()) <= 20 && abs(motor.angle - end.toInt()) <= 2
            if (isNear) "" else "$line: here $took ${motor.angle}"
        }
        assertEquals(8, told.size)
        assertEquals("", told.filter { it.isNotEmpty() }.joinToString("\n"))
    }

    @Test
    fun `a motor stops from full speed as it does with Pybricks`() {
        val lines = recorded("13-motor-stops")
        val commands = mapOf(
            "stop" to HubNative.MOTOR_STOP,
            "brake" to HubNative.MOTOR_BRAKE,
            "hold" to HubNative.MOTOR_HOLD,
            "run 0" to HubNative.MOTOR_RUN,
        )
        for ((name, command) in commands) {
            val index = lines.indexOfFirst { it.startsWith("$name at") }
            bench.on(HubNative.MOTOR_RESET_ANGLE, HubPort.B, 0)
            bench.on(HubNative.MOTOR_RUN, HubPort.B, 500)
            bench.wait(1000)
            val at = motor.angle
            assertNear(436.0, at.toDouble(), 2.0, name)
            assertNear(500.0, motor.speed.toDouble(), 10.0, "speed before $name")
            if (command == HubNative.MOTOR_RUN) bench.on(command, HubPort.B, 0) else bench.on(command, HubPort.B)
            val ways = List(8) { bench.wait(50).let { motor.angle - at } }
            val known = numbersOf(lines[index + 1]).take(8)
            for (place in ways.indices) assertNear(known[place], ways[place].toDouble(), 3.0, "$name, part $place")
            assertEquals(0, motor.speed, name)
            bench.on(HubNative.MOTOR_STOP, HubPort.B)
            bench.wait(500)
        }
    }

    @Test
    fun `a motor that runs against its end is stalled after 200 milliseconds`() {
        val table = HubBench().apply {
            stops(MotorPort.C, -142.0, 142.0)
            make(HubPort.C)
            on(HubNative.MOTOR_RUN, HubPort.C, 300)
        }
        val stalled = table.until { table.motor(HubPort.C).isStalled }
        assertEquals(142, table.motor(HubPort.C).angle)
        assertNear(780.0, stalled.toDouble(), 60.0, "until it is stalled")
        assertTrue(recorded("15-motor-stall").contains("stalled 142 780"))
        table.on(HubNative.MOTOR_RUN, HubPort.C, -300)
        table.wait(300)
        assertFalse(table.motor(HubPort.C).isStalled)
    }

    @Test
    fun `the later of two commands wins, and who waits for the earlier sees it`() {
        bench.make(HubPort.E)
        bench.on(HubNative.MOTOR_RUN_ANGLE, HubPort.B, 500, 360, 1)
        bench.on(HubNative.MOTOR_RUN_ANGLE, HubPort.E, 300, 180, 1)
        val both = bench.until { motor.isDone && bench.motor(HubPort.E).isDone }
        assertNear(1000.0, both.toDouble(), 30.0, "both")
        bench.on(HubNative.MOTOR_RESET_ANGLE, HubPort.B, 0)
        bench.on(HubNative.MOTOR_RUN_ANGLE, HubPort.B, 200, 720, 0)
        val first = motor.commands
        bench.wait(500)
        assertEquals(first, motor.commands)
        bench.on(HubNative.MOTOR_RUN_TARGET, HubPort.B, 500, 0, 0)
        assertTrue(motor.commands > first)
        bench.until { motor.isDone }
        assertNear(1.0, motor.angle.toDouble(), 2.0, "angle")
    }

    @Test
    fun `a motor keeps to the highest speed of its kind and turns the other way round if it is reversed`() {
        bench.make(HubPort.C, isReversed = true)
        bench.on(HubNative.MOTOR_RUN, HubPort.B, 5000)
        bench.on(HubNative.MOTOR_RUN, HubPort.C, 300)
        bench.wait(1000)
        assertNear(960.0, motor.speed.toDouble(), 20.0, "speed")
        assertNear(300.0, bench.motor(HubPort.C).speed.toDouble(), 10.0, "reversed")
        assertEquals(MotorMode.BACKWARD, bench.brick.motor(MotorPort.C).mode)
        assertEquals(MotorMode.FORWARD, bench.brick.state.motors[MotorPort.C.ordinal].mode)
    }

    @Test
    fun `limits and tolerances are those that Pybricks prints`() {
        val lines = recorded("14-motor-limits")
        for ((kind, line) in listOf(HubMotorKind.MEDIUM, HubMotorKind.LARGE, HubMotorKind.SMALL).zip(lines)) {
            val limits = numbersOf(line.substringAfter("limits").substringBefore("pid"))
            val expected = listOf(kind.highestSpeed, HubMotorKind.ACCELERATION, kind.torque)
            assertEquals(expected, limits.map { it.toInt() }, line)
            val tolerance = numbersOf(line.substringAfter("target").substringBefore("stall")).last().toInt()
            assertEquals(kind.angleTolerance, tolerance, line)
        }
    }

    @Test
    fun `the angle of a motor with a mark begins where its mark is, that of another with 0`() {
        val marked = HubBench()
        marked.brick.setMotorDegrees(MotorPort.C, 483.0)
        marked.make(HubPort.C)
        assertEquals(123, marked.motor(HubPort.C).angle)
        val plain = HubBench(kind = HubMotorKind.EV3_LARGE)
        plain.brick.setMotorDegrees(MotorPort.C, 483.0)
        plain.make(HubPort.C)
        assertEquals(0, plain.motor(HubPort.C).angle)
    }
}

internal fun assertNear(expected: Double, actual: Double, tolerance: Double, what: String) =
    assertTrue(abs(expected - actual) <= tolerance, "$what: $actual, not $expected")
