package robotran.simulation.robot

import robotran.rcxrom.controls.MotorMode
import robotran.rcxrom.controls.MotorState
import robotran.simulation.config.SimulationLimits
import robotran.world.Penbot
import kotlin.math.abs

/**
 * A motor with its gears, as the speed of the tyre in cm/s. How fast it turns depends on the share of the time for
 * which its port is switched on, on the voltage, and on what holds against it: a load slows it down, the more the less
 * it is driven, and stalls it in the end.
 *
 * It runs on the average of the port's pulses rather than on each of them: the pulses are ten times shorter than the
 * motor can follow, and which of them a command happens to begin with would make the same program drive a little
 * further or less far.
 */
internal class Motor {
    /** Forwards positive. */
    var speed = 0.0
        private set

    /**
     * Lets one tick pass.
     *
     * @param supply its strength and the voltage, as a part of what a good motor has with fresh batteries.
     * @param load what holds back the tyre on its way forwards, in kg cm/s2; negative if it pushes it on.
     */
    fun tick(told: MotorState, supply: Double = 1.0, load: Double = 0.0) {
        speed = when (told.mode) {
            MotorMode.FORWARD -> approach(loadedSpeed(told.power, supply, load))
            MotorMode.BACKWARD -> approach(-loadedSpeed(told.power, supply, -load))
            MotorMode.BRAKE -> approach(0.0)
            MotorMode.FLOAT -> coast()
        }
    }

    /** The tyre is turned by the floor at [ground] cm/s while nothing drives or brakes it. */
    fun follow(ground: Double) {
        speed = ground
    }

    private fun loadedSpeed(power: Int, supply: Double, load: Double): Double {
        val free = drivenSpeed(power) * supply
        if (load == 0.0) return free
        val strongest = Penbot.STALL_FORCE * (power + 1) / SLOTS * supply
        return free * (1 - load / strongest).coerceIn(0.0, MAX_PUSHED)
    }

    private fun approach(target: Double): Double {
        val next = speed + (target - speed) * RESPONSE
        return if (target == 0.0 && abs(next) < SimulationLimits.STANDSTILL_SPEED) 0.0 else next
    }

    private fun coast(): Double {
        val loss = Penbot.ROLLING_DECELERATION * SimulationLimits.TICK_SECONDS
        return if (speed > 0) maxOf(0.0, speed - loss) else minOf(0.0, speed + loss)
    }

    companion object {
        private const val SLOTS = 8.0

        /** A motor that is pushed on turns no faster than this times as fast as without load. */
        private const val MAX_PUSHED = 1.2
        private const val CALIBRATED_SLOTS = Penbot.CALIBRATED_POWER + 1.0
        private const val TICK_MILLISECONDS = 1.0

        /** The part of the missing speed made up for in a tick. */
        private const val RESPONSE = TICK_MILLISECONDS / (Penbot.MOTOR_LAG + TICK_MILLISECONDS)

        /** The slots at which the speed reaches half of where the curve through the two known speeds leads to. */
        private const val HALF_SLOTS =
            SLOTS * (Penbot.TOP_SPEED - Penbot.CALIBRATED_SPEED) / (2.0 * Penbot.CALIBRATED_SPEED - Penbot.TOP_SPEED)

        /**
         * The speed of a driven tyre at a power of 0..7, in cm/s. It rises ever less with power, as that of a lightly
         * loaded gearmotor does, through [Penbot.CALIBRATED_SPEED] at [Penbot.CALIBRATED_POWER] and [Penbot.TOP_SPEED]
         * at 7.
         */
        fun drivenSpeed(power: Int): Double {
            val slots = power + 1.0
            return Penbot.CALIBRATED_SPEED * (slots * (CALIBRATED_SLOTS + HALF_SLOTS)) /
                (CALIBRATED_SLOTS * (slots + HALF_SLOTS))
        }
    }
}
