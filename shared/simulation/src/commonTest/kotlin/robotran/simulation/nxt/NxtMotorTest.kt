package robotran.simulation.nxt

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.simulation.robot.MotorPlay
import robotran.simulation.robot.NxtMotor
import robotran.world.NxtMotorParameters
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The motor by itself, in degrees a second and N cm, as builders have measured it. */
class NxtMotorTest {
    private fun motor() = NxtMotor(
        NxtMotorParameters.FREE_SPEED,
        NxtMotorParameters.STALL_TORQUE * (NxtMotorParameters.VOLTS / NxtMotorParameters.STALL_VOLTS),
        NxtMotorParameters.ROLLING_DECELERATION,
    )

    private fun described(power: Int, brakes: Boolean = true) = MotorState(
        MotorPort.A,
        if (power < 0) {
            MotorMode.BACKWARD
        } else {
            MotorMode.FORWARD
        },
        if (power < 0) -power else power,
        brakes,
    )

    /** The speed after a second at 9 volts. */
    private fun speed(power: Int, load: Double = 0.0, brakes: Boolean = true): Double = motor().apply {
        repeat(1_000) { tick(described(power, brakes), NINE_VOLTS, load) }
    }.speed

    /** The degrees that a motor turns until it stands, from full speed at 9 volts. */
    private fun way(mode: MotorMode): Double {
        val motor = motor()
        repeat(1_000) { motor.tick(described(100), NINE_VOLTS) }
        var degrees = 0.0
        repeat(2_000) {
            motor.tick(MotorState(MotorPort.A, mode, 0, true))
            degrees += motor.speed / 1000
        }
        assertEquals(0.0, motor.speed)
        return degrees
    }

    @Test
    fun `without load the speed is proportional to the power`() {
        assertEquals(1020.0, speed(100), 1020 * 0.03)
        assertEquals(510.0, speed(50), 510 * 0.03)
        assertEquals(-1020.0, speed(-100), 1020 * 0.03)
    }

    @Test
    fun `a low power does not move it`() {
        assertEquals(0.0, speed(4))
        assertTrue(speed(8) > 50)
    }

    @Test
    fun `eleven and a half newton centimetres hold it at thirty percent`() {
        assertEquals(0.0, speed(30, 11.5), 0.001)
        assertTrue(speed(45, 11.5) > 50)
        assertEquals(1020 * (1 - 11.5 / 50), speed(100, 11.5), 30.0)
        assertEquals(-speed(60, 11.5), speed(-60, -11.5), 1e-9)
    }

    @Test
    fun `if it rolls in the pauses a load slows it down much more`() {
        assertTrue(speed(50, 5.0, brakes = false) < 0.9 * speed(50, 5.0))
        assertEquals(speed(50), speed(50, brakes = false), 1.0)
    }

    @Test
    fun `it gets to full speed in a few tenths of a second`() {
        val motor = motor()
        repeat(70) { motor.tick(described(100), NINE_VOLTS) }
        assertEquals(0.63 * 1017, motor.speed, 20.0)
    }

    @Test
    fun `a motor that brakes stands soon and one that rolls does not`() {
        assertTrue(way(MotorMode.BRAKE) in 20.0..40.0, "${way(MotorMode.BRAKE)}")
        assertTrue(way(MotorMode.FLOAT) in 200.0..400.0, "${way(MotorMode.FLOAT)}")
    }

    @Test
    fun `a standing motor draws ten times as much as a free one`() {
        val motor = motor()
        motor.tick(described(100), NINE_VOLTS)
        assertEquals(10.0, motor.current, 0.5)
        repeat(1_000) { motor.tick(described(100), NINE_VOLTS) }
        assertEquals(1.0, motor.current, 0.1)
    }

    @Test
    fun `a wheel follows a motor that changes direction after the play`() {
        val play = MotorPlay(width = 0.5)
        assertEquals(0.5, play.passOn(1.0), 1e-12)
        assertEquals(0.0, play.passOn(-0.3), 1e-12)
        assertEquals(0.0, play.passOn(0.3), 1e-12)
        assertEquals(0.2, play.passOn(0.2), 1e-12)
        assertEquals(-0.5, play.passOn(-1.0), 1e-12)
        assertEquals(0.5 + 0.3 + 0.3 + 0.5, play.lost, 1e-12)
    }

    private companion object {
        const val NINE_VOLTS = 9.0 / 8
    }
}
