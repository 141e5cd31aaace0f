package robotran.hub

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import kotlin.math.abs

/**
 * A medium motor at 7.2 volts as the simulated one of Pybricks' own tests: 960 degrees a second at full power, 401 at
 * half, none below 13 percent. It turns nothing but itself, between [lower] and [upper].
 */
internal class TestMotor(
    private val port: MotorPort,
    private val lower: Double = Double.NEGATIVE_INFINITY,
    private val upper: Double = Double.POSITIVE_INFINITY,
) {
    var degrees = 0.0
    private var speed = 0.0

    /** Turns by a millisecond and tells the hub. */
    fun tick(brick: HubBrick) {
        val command = brick.motor(port)
        val power = when (command.mode) {
            MotorMode.FORWARD -> command.power.toDouble()
            MotorMode.BACKWARD -> -command.power.toDouble()
            MotorMode.BRAKE, MotorMode.FLOAT -> 0.0
        }
        follow(power)
        degrees += speed / SECOND
        if (degrees !in lower..upper) {
            degrees = degrees.coerceIn(lower, upper)
            speed = 0.0
        }
        brick.setMotorDegrees(port, degrees)
    }

    private fun follow(power: Double) {
        val against = if (speed > 0 || (speed == 0.0 && power > 0)) FRICTION else -FRICTION
        if (speed == 0.0 && abs(power) <= FRICTION) return
        val before = speed
        speed += (SLOPE * (power - against) - speed) / LAG
        if (before * speed < 0) speed = 0.0
    }

    private companion object {
        const val SLOPE = 11.1
        const val FRICTION = 13.4
        const val LAG = 40
        const val SECOND = 1000
    }
}
