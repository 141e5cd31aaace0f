package robotran.simulation.robot

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.simulation.config.SimulationLimits
import robotran.world.NxtMotorParameters
import robotran.world.robot.RobotParameters

/**
 * The motor of an NXT. Its speed is proportional to power and voltage, and falls in a straight line with the load. In the
 * pauses of the pulses it brakes or rolls; if it rolls, a load slows it down much more.
 *
 * @param topSpeed without load at full power and [NxtMotorParameters.VOLTS], in any unit of speed.
 * @param stallForce what stalls it then.
 * @param rollingDeceleration the speed that it loses in a second while it rolls.
 */
internal class NxtMotor(private val topSpeed: Double, private val stallForce: Double, rollingDeceleration: Double) :
    MotorModel() {
    constructor(f: RobotParameters) : this(
        f.topSpeed,
        f.stallForce * (NxtMotorParameters.VOLTS / NxtMotorParameters.STALL_VOLTS),
        f.rollingDeceleration,
    )

    private val loss = rollingDeceleration * SimulationLimits.TICK_SECONDS
    private val standstill = topSpeed * NxtMotorParameters.STANDSTILL

    /** The current that it draws, 1 for a free motor at full power. */
    var current = 0.0
        private set

    override fun tick(command: MotorState, supply: Double, load: Double) {
        current = 0.0
        when (command.mode) {
            MotorMode.FORWARD -> drive(command, supply, load)

            MotorMode.BACKWARD -> {
                speed = -speed
                drive(command, supply, -load)
                speed = -speed
            }

            MotorMode.BRAKE -> brake()
            MotorMode.FLOAT -> coast()
        }
    }

    /** Drives forwards, against [load]. */
    private fun drive(command: MotorState, supply: Double, load: Double) {
        val duty = if (command.power < NxtMotorParameters.LOWEST_POWER) 0.0 else command.power / FULL_POWER
        val free = topSpeed * supply * duty
        val wanted = loaded(free, stallForce * supply * (if (command.brakesInPauses) duty else duty * duty), load)
        if (free > 0) current = duty * (1 + STALLED_CURRENT * (1 - speed / free).coerceIn(0.0, 1.0))
        when {
            !command.brakesInPauses && speed > wanted -> {
                coast()
                speed = maxOf(speed, wanted)
            }

            wanted == 0.0 -> brake()

            else -> {
                // Friction helps to slow it down.
                speed += (wanted - speed) * (if (speed > wanted || speed < 0) BRAKE_RESPONSE else RESPONSE)
            }
        }
    }

    private fun loaded(free: Double, strongest: Double, load: Double): Double = when {
        free == 0.0 || load == 0.0 -> free
        load > 0 && strongest <= load * NxtMotorParameters.STICKING -> 0.0
        else -> free * (1 - load / strongest).coerceIn(0.0, MAX_PUSHED_RATIO)
    }

    private fun brake() {
        speed -= speed * BRAKE_RESPONSE
        if (speed < standstill && speed > -standstill) speed = 0.0
    }

    private fun coast() {
        speed = if (speed > 0) maxOf(0.0, speed - loss) else minOf(0.0, speed + loss)
    }

    companion object {
        /** How much more current a standing motor draws than a free one: 2 A and 0.06 A for two of them. */
        const val STALLED_CURRENT = 9.0

        private const val FULL_POWER = 100.0
        private const val MAX_PUSHED_RATIO = 1.2
        private const val RESPONSE = 1.0 / (NxtMotorParameters.LAG + 1)
        private const val BRAKE_RESPONSE = 1.0 / (NxtMotorParameters.BRAKE_LAG + 1)
    }
}
