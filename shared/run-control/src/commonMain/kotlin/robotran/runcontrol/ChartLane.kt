package robotran.runcontrol

import robotran.brick.kind.BrickKind

/**
 * The lanes of a robot's chart over time: its sensor readings, motor commands, the counters of its motors
 * and its battery.
 *
 * @property kinds the bricks whose robots have the lane.
 */
enum class ChartLane(val kinds: Set<BrickKind> = BrickKind.entries.toSet()) {
    SENSOR_1,
    SENSOR_2,
    SENSOR_3,

    /**
     * For an RCX, the power plus one, 1..8 forwards and -1..-8 backwards; 0 if the motor is not driven, which differs
     * from power 0. For an NXT, the power in percent, -100..100.
     */
    MOTOR_A,
    MOTOR_B,
    MOTOR_C,
    SENSOR_4(setOf(BrickKind.NXT)),

    /** What the counter of the motor says, in degrees. */
    DEGREES_A(setOf(BrickKind.NXT)),
    DEGREES_B(setOf(BrickKind.NXT)),
    DEGREES_C(setOf(BrickKind.NXT)),

    /** What the brick measures, which sinks under load. */
    BATTERY(setOf(BrickKind.NXT)),
    ;

    val isMotor: Boolean get() = this in MOTOR_A..MOTOR_C
    val isDegrees: Boolean get() = this in DEGREES_A..DEGREES_C
    val isSensor: Boolean get() = !isMotor && !isDegrees && this != BATTERY

    /** Index of the port that the lane is about, among the motors or the sensors; 0 for the battery. */
    val port: Int
        get() = when (this) {
            SENSOR_1, MOTOR_A, DEGREES_A, BATTERY -> 0
            SENSOR_2, MOTOR_B, DEGREES_B -> 1
            SENSOR_3, MOTOR_C, DEGREES_C -> 2
            SENSOR_4 -> 3
        }

    companion object {
        /** The lanes of a robot with a [kind] of brick: sensors, then motors, then their counters, then the battery. */
        fun of(kind: BrickKind): List<ChartLane> = entries.filter { kind in it.kinds }.sortedBy {
            when {
                it.isSensor -> 0
                it.isMotor -> 1
                else -> 2
            }
        }
    }
}
