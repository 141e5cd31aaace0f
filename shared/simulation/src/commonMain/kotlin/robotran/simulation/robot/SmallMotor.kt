package robotran.simulation.robot

import robotran.brick.controls.MotorState
import robotran.simulation.config.SimulationLimits
import robotran.simulation.noise.WheelNoise
import robotran.world.NxtMotorParameters

/** A motor of an NXT that turns no wheel, but something light between two end stops, or nothing. */
internal class SmallMotor(private val noise: WheelNoise, private val first: Double, private val last: Double) {
    private val motor = NxtMotor(
        NxtMotorParameters.FREE_SPEED,
        NxtMotorParameters.STALL_TORQUE * (NxtMotorParameters.VOLTS / NxtMotorParameters.STALL_VOLTS),
        NxtMotorParameters.ROLLING_DECELERATION,
    )

    /** Degrees that it has turned. */
    var degrees = 0.0
        private set

    val current: Double get() = motor.current

    fun tick(command: MotorState, battery: Double, tick: Long) {
        noise.tick(tick)
        motor.tick(command, noise.strength * noise.flutter * battery)
        val wanted = degrees + motor.speed * SimulationLimits.TICK_SECONDS
        degrees = wanted.coerceIn(first, last)
        if (degrees != wanted) motor.follow(0.0)
    }
}
