package robotran.simulation.nxt

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.nxt.regulator.MotorRegulator
import robotran.nxt.regulator.RegulatedMotor
import robotran.simulation.robot.NxtMotor
import robotran.world.NxtMotorParameters
import kotlin.math.floor
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** A motor with its regulator on a test bench, in degrees a second, N cm and volts. */
class RegulatedNxtTest {
    private class MotorInTest(private val volts: Double = NxtMotorParameters.VOLTS, private val load: Double = 0.0) :
        RegulatedMotor {
        private val motor = NxtMotor(
            NxtMotorParameters.FREE_SPEED,
            NxtMotorParameters.STALL_TORQUE * (NxtMotorParameters.VOLTS / NxtMotorParameters.STALL_VOLTS),
            NxtMotorParameters.ROLLING_DECELERATION,
        )
        val regulator = MotorRegulator(this)
        private var described = MotorState(MotorPort.A, MotorMode.FLOAT, 0)
        var degrees = 0.0
            private set

        override val tachoCount: Int get() = floor(degrees + 0.5).toInt()

        override fun control(power: Int, brakes: Boolean) {
            val mode = if (power < 0) {
                MotorMode.BACKWARD
            } else if (power > 0) {
                MotorMode.FORWARD
            } else {
                MotorMode.BRAKE
            }
            described = MotorState(MotorPort.A, mode, if (power < 0) -power else power, brakes)
        }

        fun run(milliseconds: Int) = repeat(milliseconds) {
            if (it % MotorRegulator.PERIOD == 0) regulator.tick()
            motor.tick(described, volts / NxtMotorParameters.VOLTS, load)
            degrees += motor.speed / 1000
        }

        /** The mean speed of the second that follows. */
        fun speed(): Double {
            val before = degrees
            run(1_000)
            return degrees - before
        }

        fun forward(speed: Float) = regulator.start(speed, 6_000, MotorRegulator.FORWARD, hold = true)
    }

    @Test
    fun `a load does not change the speed of a regulated motor`() {
        for (load in listOf(0.0, 5.0, 11.5)) {
            val bench = MotorInTest(load = load)
            bench.forward(360f)
            bench.run(1_500)
            assertEquals(360.0, bench.speed(), 4.0, "at $load N cm")
        }
    }

    @Test
    fun `a weak battery slows a fast motor down but does not stall it`() {
        val bench = MotorInTest(volts = 6.5)
        bench.forward(900f)
        bench.run(6_000)
        assertTrue(bench.speed() in 650.0..735.0)
        assertFalse(bench.regulator.isStalled)
    }

    @Test
    fun `it ends within a degree of its limit`() {
        for (limit in listOf(1, 45, 90, 360, 1_000, -360)) {
            val bench = MotorInTest()
            bench.regulator.start(360f, 6_000, limit, hold = true)
            bench.run(6_000)
            assertFalse(bench.regulator.isMoving)
            assertEquals(limit.toDouble(), bench.degrees, 1.0)
        }
    }

    @Test
    fun `seven hundred and twenty degrees one by one are two turns`() {
        val bench = MotorInTest()
        for (degree in 1..720) {
            bench.regulator.start(360f, 6_000, degree, hold = true)
            while (bench.regulator.isMoving) bench.run(4)
        }
        assertEquals(720.0, bench.degrees, 2.0)
    }

    @Test
    fun `a motor that cannot move stalls after four seconds`() {
        val bench = MotorInTest(load = 100.0)
        bench.forward(360f)
        bench.run(3_000)
        assertFalse(bench.regulator.isStalled)
        bench.run(2_000)
        assertTrue(bench.regulator.isStalled)
    }
}
