package robotran.nxt

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort

/**
 * A motor that turns nothing but a load: it follows its power and voltage with a time constant of 70 milliseconds,
 * stands 30 degrees after braking from full speed, and rolls for long.
 *
 * @param load torque in N cm.
 */
internal class FreeMotor(private val port: MotorPort, var volts: Double = 8.0, var load: Double = 0.0) {
    private var speed = 0.0
    private var degrees = 0.0

    /** Whether somebody holds it fast. */
    var isHeld = false

    /** Turns by a millisecond and tells the brick. */
    fun tick(brick: NxtBrick) {
        val command = brick.motor(port)
        val duty = if (command.power < LEAST_POWER) 0.0 else command.power / 100.0
        when (command.mode) {
            MotorMode.FORWARD -> follow(duty)
            MotorMode.BACKWARD -> follow(-duty)
            MotorMode.BRAKE -> speed -= speed / BRAKE_TIME
            MotorMode.FLOAT -> speed = if (speed > 0) maxOf(0.0, speed - ROLLING) else minOf(0.0, speed + ROLLING)
        }
        if (isHeld) speed = 0.0
        degrees += speed / 1000
        brick.setHubDegrees(port, kotlin.math.floor(degrees).toInt())
    }

    private fun follow(duty: Double) {
        val free = 113 * volts * duty
        val stall = 50 * volts / 9 * kotlin.math.abs(duty)
        val wanted = if (stall <= load) 0.0 else free * (1 - load / stall)
        speed += (wanted - speed) / TIME_CONSTANT
    }

    private companion object {
        const val LEAST_POWER = 5
        const val TIME_CONSTANT = 71.0
        const val BRAKE_TIME = 31.0
        const val ROLLING = 1.7
    }
}
