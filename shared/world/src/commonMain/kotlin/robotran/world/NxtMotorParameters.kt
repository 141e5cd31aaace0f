package robotran.world

/**
 * The motor of an NXT, without gears behind it. Speeds are in degrees a second at its hub, torques in N cm, times in
 * milliseconds, voltages in volts.
 */
object NxtMotorParameters {
    /** Speed of a free motor at full power, per volt. Builders measured 1020 degrees a second at 9 volts. */
    const val SPEED_PER_VOLT = 113.0

    /** The voltage of a charged accumulator, which an ideal world has all the time. */
    const val VOLTS = 8.0
    const val FREE_SPEED = SPEED_PER_VOLT * VOLTS

    /** Eight tenths of 100 degrees a second per volt: how fast a pilot drives by itself. */
    const val PILOT_SPEED = 640.0

    /** Time constant with which a motor follows its power, and with which one stands that brakes. */
    const val LAG = 70.0
    const val BRAKE_LAG = 30.0

    /** What stalls a motor at full power at [STALL_VOLTS], and the part of it that hub and gears leave to a wheel. */
    const val STALL_TORQUE = 50.0
    const val STALL_VOLTS = 9.0
    const val GEAR_EFFICIENCY = 0.95

    /** Deceleration of a rolling motor by its friction, in degrees a second each second. */
    const val ROLLING_DECELERATION = 1700.0

    /** Percent of power below which a motor does not move. */
    const val LOWEST_POWER = 5

    /**
     * Against a load, a motor moves only if its stall torque at this power is more than that many times the load: 11.5
     * N cm keep it standing up to 40 percent at 9 volts.
     */
    const val STICKING = 1.7

    /** Speed of a braking motor at which it stands, as a part of the free one. */
    const val STANDSTILL = 0.005

    /** Where the ends of a pen's way are, in degrees from where it hangs at the start. Its tip is down at four fifths. */
    const val PEN_TOP = -5.0
    const val PEN_BOTTOM = 95.0

    /** How far a turret turns to either side, in degrees. */
    const val TURRET_END = 180.0
}
