package robotran.simulation.robot

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.simulation.config.SimulationLimits
import robotran.world.Penbot
import robotran.world.robot.RobotParameters
import kotlin.math.abs

/** A motor with its gears, modelled as the speed of the tyre that it turns, in cm/s. */
internal abstract class MotorModel {
    /** Forwards positive. */
    var speed = 0.0
        protected set

    /**
     * Advances by one tick.
     *
     * @param supply strength times voltage, relative to a nominal motor with fresh batteries.
     * @param load the force against the tyre's forward movement, in kg cm/s2; negative if it pushes the tyre.
     */
    abstract fun tick(command: MotorState, supply: Double = 1.0, load: Double = 0.0)

    /** Lets the floor turn the tyre at [ground] cm/s while the motor neither drives nor brakes. */
    fun follow(ground: Double) {
        speed = ground
    }
}

/**
 * The motor of an RCX. The speed depends on the duty cycle of its port, the voltage and the load. A load slows the motor
 * down, more so at low power, and finally stalls it.
 *
 * The model uses the average of the port's pulses. They are ten times shorter than the motor's response, and single
 * pulses would make the same program drive slightly different distances, depending on the pulse at which a command
 * starts.
 */
internal class RcxMotor(private val f: RobotParameters) : MotorModel() {
    /** The part of the speed difference made up for in a tick. */
    private val response = TICK_MILLISECONDS / (f.motorLag + TICK_MILLISECONDS)

    /** The slots at which the speed reaches half of the limit of the curve through the two known speeds. */
    private val halfSlots = SLOTS * (f.topSpeed - f.calibratedSpeed) / (2.0 * f.calibratedSpeed - f.topSpeed)

    override fun tick(command: MotorState, supply: Double, load: Double) {
        speed = when (command.mode) {
            MotorMode.FORWARD -> approach(loadedSpeed(command.power, supply, load))
            MotorMode.BACKWARD -> approach(-loadedSpeed(command.power, supply, -load))
            MotorMode.BRAKE -> approach(0.0)
            MotorMode.FLOAT -> coast()
        }
    }

    /**
     * The speed of a driven tyre at a power of 0..7, in cm/s. It rises less and less with power, like that of a lightly
     * loaded gearmotor, through [RobotParameters.calibratedSpeed] at [Penbot.CALIBRATED_POWER] and [RobotParameters.topSpeed]
     * at 7.
     */
    fun drivenSpeed(power: Int): Double {
        val slots = power + 1.0
        return f.calibratedSpeed * (slots * (CALIBRATED_SLOTS + halfSlots)) /
            (CALIBRATED_SLOTS * (slots + halfSlots))
    }

    private fun loadedSpeed(power: Int, supply: Double, load: Double): Double {
        val free = drivenSpeed(power) * supply
        if (load == 0.0) return free
        val strongest = f.stallForce * (power + 1) / SLOTS * supply
        return free * (1 - load / strongest).coerceIn(0.0, MAX_PUSHED_RATIO)
    }

    private fun approach(target: Double): Double {
        val next = speed + (target - speed) * response
        return if (target == 0.0 && abs(next) < SimulationLimits.STANDSTILL_SPEED) 0.0 else next
    }

    private fun coast(): Double {
        val loss = f.rollingDeceleration * SimulationLimits.TICK_SECONDS
        return if (speed > 0) maxOf(0.0, speed - loss) else minOf(0.0, speed + loss)
    }

    private companion object {
        const val SLOTS = 8.0

        /** Max speed of a pushed motor, relative to its speed without load. */
        const val MAX_PUSHED_RATIO = 1.2
        const val CALIBRATED_SLOTS = Penbot.CALIBRATED_POWER + 1.0
        const val TICK_MILLISECONDS = 1.0
    }
}
