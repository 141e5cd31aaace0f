package robotran.nxt.regulator

/** A motor as a [MotorRegulator] knows it. */
interface RegulatedMotor {
    /** Degrees that it has turned since it was counted from 0. */
    val tachoCount: Int

    /**
     * @param power -100..100; below 0 is backward.
     * @param brakes whether it brakes in the pauses of the pulses, and with power 0; otherwise it rolls.
     */
    fun control(power: Int, brakes: Boolean)
}
