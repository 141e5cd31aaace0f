package robotran.hub.model

/**
 * The motors that Pybricks tells apart, with the figures of its controller.
 *
 * @property highestSpeed the limit of its speed, degrees a second.
 * @property torque the limit of its torque, millinewton metres at full voltage.
 * @property angleTolerance how near an angle counts as reached, degrees.
 * @property freeSpeed what it turns without load at full power, degrees a second.
 */
enum class HubMotorKind(val highestSpeed: Int, val torque: Int, val angleTolerance: Int, val freeSpeed: Double) {
    /** The small angular motor of SPIKE Essential. */
    SMALL(620, 62, 11, freeSpeed = 762.0),

    /** The medium angular motor of SPIKE Prime and Robot Inventor. */
    MEDIUM(1000, 199, 11, freeSpeed = 1110.0),
    LARGE(1000, 560, 11, freeSpeed = 1050.0),
    EV3_LARGE(800, 448, 10, freeSpeed = 1050.0),
    EV3_MEDIUM(1200, 206, 10, freeSpeed = 1560.0),
    NXT(800, 555, 5, freeSpeed = 1020.0),
    ;

    /** Whether it has a mark by which it knows its angle when it is switched on. */
    val hasMark: Boolean get() = this == SMALL || this == MEDIUM || this == LARGE

    companion object {
        /** How fast each gets faster and slower, degrees a second in a second. */
        const val ACCELERATION = 2000
    }
}
