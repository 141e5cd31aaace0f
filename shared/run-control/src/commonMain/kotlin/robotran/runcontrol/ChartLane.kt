package robotran.runcontrol

import robotran.brick.kind.BrickKind

/**
 * The lanes of a robot's chart over time: its sensor readings, motor commands, the counters of its motors
 * and its battery.
 */
enum class ChartLane {
    SENSOR_1,
    SENSOR_2,
    SENSOR_3,

    /**
     * Where power is counted in steps, the power plus one, 1..8 forwards and -1..-8 backwards; 0 if the motor is not
     * driven, which differs from power 0. Otherwise the power in percent, -100..100.
     */
    MOTOR_A,
    MOTOR_B,
    MOTOR_C,
    SENSOR_4,

    /** What the counter of the motor says, in degrees. */
    DEGREES_A,
    DEGREES_B,
    DEGREES_C,

    /** What the brick measures, which sinks under load. */
    BATTERY,
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

    private fun isOn(kind: BrickKind): Boolean = when {
        isSensor -> port < kind.inputPorts
        isDegrees -> kind.hasMotorCounters && port < kind.motorPorts.size
        isMotor -> port < kind.motorPorts.size
        this == BATTERY -> kind.chartsBattery
        else -> true
    }

    companion object {
        /** The lanes of a robot with a [kind] of brick: sensors, then motors, then their counters, then the battery. */
        fun of(kind: BrickKind): List<ChartLane> = entries.filter { it.isOn(kind) }.sortedBy {
            when {
                it.isSensor -> 0
                it.isMotor -> 1
                else -> 2
            }
        }
    }
}
