package robotran.runcontrol

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.world.RobotDescription
import robotran.world.pluggedMotors

/**
 * The lanes of a robot's chart over time: its sensor readings, motor commands, the counters of its motors
 * and its battery.
 */
enum class ChartLane {
    SENSOR_1,
    SENSOR_2,
    SENSOR_3,
    SENSOR_4,
    SENSOR_5,
    SENSOR_6,

    /**
     * Where power is counted in steps, the power plus one, 1..8 forwards and -1..-8 backwards; 0 if the motor is not
     * driven, which differs from power 0. Otherwise the power in percent, -100..100.
     */
    MOTOR_A,
    MOTOR_B,
    MOTOR_C,
    MOTOR_D,
    MOTOR_E,
    MOTOR_F,

    /** What the counter of the motor says, in degrees. */
    DEGREES_A,
    DEGREES_B,
    DEGREES_C,
    DEGREES_D,
    DEGREES_E,
    DEGREES_F,

    /** What the brick measures, which sinks under load. */
    BATTERY,
    ;

    val isSensor: Boolean get() = this in SENSOR_1..SENSOR_6
    val isMotor: Boolean get() = this in MOTOR_A..MOTOR_F
    val isDegrees: Boolean get() = this in DEGREES_A..DEGREES_F

    /** Index of the port that the lane is about, among the motors or the sensors; 0 for the battery. */
    val port: Int
        get() = when {
            isSensor -> ordinal - SENSOR_1.ordinal
            isMotor -> ordinal - MOTOR_A.ordinal
            isDegrees -> ordinal - DEGREES_A.ordinal
            else -> 0
        }

    private fun isOn(kind: BrickKind): Boolean = when {
        isSensor -> port < kind.inputPorts
        isDegrees -> kind.hasMotorCounters && port < kind.motorPorts.size
        isMotor -> port < kind.motorPorts.size
        else -> kind.chartsBattery
    }

    /** Whether something of [robot] is on the port. */
    private fun isPlugged(robot: RobotDescription): Boolean = when {
        isSensor -> robot.parts.any { it.port == port + 1 }
        this == BATTERY -> true
        else -> MotorPort.entries[port] in robot.pluggedMotors
    }

    companion object {
        /** The lanes of a robot with a [kind] of brick: sensors, then motors, then their counters, then the battery. */
        fun of(kind: BrickKind): List<ChartLane> = entries.filter { it.isOn(kind) }

        /** Those of [robot]; where a port takes motors as well as sensors, only those of what is on it. */
        fun of(robot: RobotDescription): List<ChartLane> =
            of(robot.brick).filter { !robot.brick.hasLetteredInputs || it.isPlugged(robot) }
    }
}
