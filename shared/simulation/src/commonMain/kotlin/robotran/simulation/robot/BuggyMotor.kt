package robotran.simulation.robot

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.kind.WheelTrim
import robotran.simulation.config.SimulationLimits
import robotran.simulation.noise.Realism
import robotran.world.MicrobitMotorParameters
import robotran.world.robot.RobotParameters
import kotlin.math.abs

/**
 * The motor of a micro:bit buggy, whose power is in percent. Its speed rises less and less with power, through the
 * speeds that [RobotParameters] has for 45 and for 100 percent; below a lowest power it only hums. It starts and stops
 * with the same lag, so that a time drives exactly its way; in a realistic world the lag is longer.
 *
 * @param trim what programs multiply the power of this wheel by. Since they do, the wheel is one that is faster: at the power
 * at which a pupil measures by just as much as that slows it down.
 */
internal class BuggyMotor(private val f: RobotParameters, realism: Double, trim: Double = 1.0) : MotorModel() {
    private val response = TICK_MILLISECONDS / (f.motorLag + realism * Realism.BUGGY_LAG + TICK_MILLISECONDS)

    /** The power at which the speed reaches half of the limit of the curve through the two known speeds. */
    private val halfPower = ALL * CALIBRATED * (f.topSpeed - f.calibratedSpeed) /
        (ALL * f.calibratedSpeed - CALIBRATED * f.topSpeed)

    private val drift = f.calibratedSpeed / maxOf(
        drivenSpeed(WheelTrim.percentOf(MicrobitMotorParameters.CALIBRATED_PERCENT, trim)),
        SimulationLimits.STANDSTILL_SPEED,
    )

    override fun tick(command: MotorState, supply: Double, load: Double) {
        val target = when (command.mode) {
            MotorMode.FORWARD -> loadedSpeed(command.power, supply, load)
            MotorMode.BACKWARD -> -loadedSpeed(command.power, supply, -load)
            MotorMode.BRAKE, MotorMode.FLOAT -> 0.0
        }
        val next = speed + (target - speed) * response
        speed = if (target == 0.0 && abs(next) < SimulationLimits.STANDSTILL_SPEED) 0.0 else next
    }

    /** The speed of a driven tyre without load at a power of 0..100 percent, in cm/s. */
    fun drivenSpeed(percent: Int): Double = if (percent < MicrobitMotorParameters.LOWEST_PERCENT) {
        0.0
    } else {
        f.calibratedSpeed * (percent * (CALIBRATED + halfPower)) / (CALIBRATED * (percent + halfPower))
    }

    private fun loadedSpeed(percent: Int, supply: Double, load: Double): Double {
        val free = drivenSpeed(percent) * supply * drift
        if (load == 0.0 || free == 0.0) return free
        val strongest = f.stallForce * percent / ALL * supply
        return free * (1 - load / strongest).coerceIn(0.0, MAX_PUSHED_RATIO)
    }

    private companion object {
        const val CALIBRATED = MicrobitMotorParameters.CALIBRATED_PERCENT.toDouble()
        const val ALL = 100.0
        const val TICK_MILLISECONDS = 1.0

        /** Max speed of a pushed motor, relative to its speed without load. */
        const val MAX_PUSHED_RATIO = 1.2
    }
}
