package robotran.world

import robotran.rom.MotorMode
import robotran.rom.MotorState
import kotlin.math.abs

/**
 * A motor with its gears, as the speed of the tyre in cm/s.
 *
 * It runs on the average of the port's pulses rather than on each of them: the pulses are ten times shorter than the motor can follow,
 * and which of them a command happens to begin with would make the same program drive a little further or less far.
 */
internal class Motor {
    /** Forwards positive. */
    var speed = 0.0
        private set

    /** Lets one tick pass and returns how far the tyre has rolled in it, in centimetres. */
    fun tick(told: MotorState): Double {
        speed = when (told.mode) {
            MotorMode.FORWARD -> approach(drivenSpeed(told.power))
            MotorMode.BACKWARD -> approach(-drivenSpeed(told.power))
            MotorMode.BRAKE -> approach(0.0)
            MotorMode.FLOAT -> coast()
        }
        return speed * SimulationLimits.TICK_SECONDS
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
        private const val CALIBRATED_SLOTS = Penbot.CALIBRATED_POWER + 1.0
        private const val TICK_MILLISECONDS = 1.0

        /** The part of the missing speed made up for in a tick. */
        private const val RESPONSE = TICK_MILLISECONDS / (Penbot.MOTOR_LAG + TICK_MILLISECONDS)

        /** The slots at which the speed reaches half of where the curve through the two known speeds leads to. */
        private const val HALF_SLOTS =
            SLOTS * (Penbot.TOP_SPEED - Penbot.CALIBRATED_SPEED) / (2.0 * Penbot.CALIBRATED_SPEED - Penbot.TOP_SPEED)

        /**
         * The speed of a driven tyre at a power of 0..7, in cm/s. It rises ever less with power, as that of a lightly loaded gearmotor does,
         * through [Penbot.CALIBRATED_SPEED] at [Penbot.CALIBRATED_POWER] and [Penbot.TOP_SPEED] at 7.
         */
        fun drivenSpeed(power: Int): Double {
            val slots = power + 1.0
            return Penbot.CALIBRATED_SPEED * (slots * (CALIBRATED_SLOTS + HALF_SLOTS)) / (CALIBRATED_SLOTS * (slots + HALF_SLOTS))
        }
    }
}
