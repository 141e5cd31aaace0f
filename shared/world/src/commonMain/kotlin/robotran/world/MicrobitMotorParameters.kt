package robotran.world

/**
 * The motor of a micro:bit buggy with a gear of 1, as a speed of its wheel in centimetres a second; a gear of 2 halves it. All
 * are start values of ours: makers publish none, and what others simulate differs by half.
 */
object MicrobitMotorParameters {
    /** The power, in percent, at which a pupil measures, and the speed then. */
    const val CALIBRATED_PERCENT = 45
    const val CALIBRATED_SPEED = 20.0

    /** The speed with full power: simulators of two buggies have 1.4 to 2 times that of half the power. */
    const val TOP_SPEED = 30.0

    /** Percent of power below which a motor only hums. */
    const val LOWEST_PERCENT = 15

    /**
     * Time constant with which a motor starts and stops in an ideal world, in milliseconds. Builders see 50 to 150; a shorter
     * one would make the tyres of so light a robot slip when a turn follows a drive.
     */
    const val LAG = 50.0

    /** The stall torque of a small gearmotor behind its gears, in N cm (estimate). */
    const val STALL_TORQUE = 5.0
}
