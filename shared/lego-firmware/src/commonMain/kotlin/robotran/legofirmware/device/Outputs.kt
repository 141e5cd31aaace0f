package robotran.legofirmware.device

import robotran.brick.controls.MotorMode
import robotran.rcxrom.call.RomAddress

/**
 * The three motors: what the program set for each, and above that the global layer of firmware 2.0, which can disable
 * a motor, turn its direction round and limit its power.
 */
internal class Outputs(private val rom: RomCalls) {
    private val motors = List(MOTORS) { Motor(FIRST_CODE + it) }

    /** Sets the motors of [stateAndMask]: [ON], [OFF] or, without either, float. A disabled motor stays as it is. */
    fun switch(stateAndMask: Int) = each(stateAndMask) {
        if (it.isEnabled) {
            it.state = stateOf(stateAndMask)
            it.apply()
        }
    }

    /** Sets the direction: [FORWARD], [OTHER_WAY] or, without either, backward. */
    fun turn(directionAndMask: Int) = each(directionAndMask) {
        it.isForward = turned(directionAndMask, it.isForward)
        if (it.isEnabled) it.apply()
    }

    fun power(mask: Int, power: Int) = each(mask) {
        it.power = power
        if (it.isEnabled) it.apply()
    }

    /** Enables motors ([ON]), or disables them and switches them off ([OFF]) or to float. */
    fun enable(stateAndMask: Int) = each(stateAndMask) {
        val state = stateOf(stateAndMask)
        it.isEnabled = state == ON
        if (!it.isEnabled) it.state = state
        it.apply()
    }

    fun turnAll(directionAndMask: Int) = each(directionAndMask) {
        it.isNormal = turned(directionAndMask, it.isNormal)
        it.apply()
    }

    fun limitPower(mask: Int, power: Int) = each(mask) {
        it.greatestPower = power
        it.apply()
    }

    /** Enables all motors in their normal direction with full power, without a change of what they do now. */
    fun resetGlobalLayer() = motors.forEach {
        it.isEnabled = true
        it.isNormal = true
        it.greatestPower = FULL_POWER
    }

    fun stop() = each(ALL) {
        it.state = OFF
        it.apply()
    }

    fun float() = each(ALL) {
        it.state = 0
        it.apply()
    }

    /** The state of motor 0..2 as one byte: power, 8 for backward, [OFF], [ON]. */
    fun stateOfMotor(number: Int): Int? = motors.getOrNull(number)?.let {
        it.power or (if (it.isForward) 0 else BACKWARD_BIT) or it.state
    }

    /** Like [stateOfMotor] for the global layer. */
    fun globalStateOfMotor(number: Int): Int? = motors.getOrNull(number)?.let {
        it.greatestPower or (if (it.isNormal) 0 else BACKWARD_BIT) or (if (it.isEnabled) ON else OFF)
    }

    /** Whether motor 0..2 drives, and whether forward; null if it does not drive. */
    fun drivesForward(number: Int): Boolean? = motors[number].run { if (state == ON) isForward == isNormal else null }

    fun powerOfMotor(number: Int): Int = motors[number].power

    private inner class Motor(private val code: Int) {
        var state = 0
        var isForward = true
        var power = FULL_POWER
        var isEnabled = true
        var isNormal = true
        var greatestPower = FULL_POWER

        fun apply() {
            val mode = when {
                state == OFF -> MotorMode.BRAKE
                state != ON -> MotorMode.FLOAT
                isForward == isNormal -> MotorMode.FORWARD
                else -> MotorMode.BACKWARD
            }
            val strength = if (state == ON) minOf(power, greatestPower) else FULL_POWER
            rom.call(RomAddress.CONTROL_MOTOR, code, mode.code, strength)
        }
    }

    private inline fun each(mask: Int, change: (Motor) -> Unit) =
        motors.forEachIndexed { number, motor -> if (mask and (1 shl number) != 0) change(motor) }

    private fun stateOf(byte: Int): Int = if (byte and ON != 0) ON else byte and OFF

    private fun turned(byte: Int, isForward: Boolean): Boolean = when {
        byte and OTHER_WAY != 0 -> !isForward
        else -> byte and FORWARD != 0
    }

    companion object {
        const val MOTORS = 3
        const val FULL_POWER = 7
        const val ON = 0x80
        const val OFF = 0x40
        const val FORWARD = 0x80
        const val OTHER_WAY = 0x40
        private const val ALL = 7
        private const val BACKWARD_BIT = 0x08

        /** The ROM's code of motor A; those of B and C follow. */
        private const val FIRST_CODE = 0x2000
    }
}
