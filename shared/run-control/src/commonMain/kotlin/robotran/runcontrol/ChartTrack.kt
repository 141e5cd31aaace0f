package robotran.runcontrol

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.kind.BrickKind
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState

/**
 * The lanes of a robot's chart over time: its sensor readings, motor commands and the counters of its motors.
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
    ;

    val isMotor: Boolean get() = this in MOTOR_A..MOTOR_C
    val isDegrees: Boolean get() = this in DEGREES_A..DEGREES_C

    /** Index of the port that the lane is about, among the motors or the sensors. */
    val port: Int
        get() = when (this) {
            SENSOR_1, MOTOR_A, DEGREES_A -> 0
            SENSOR_2, MOTOR_B, DEGREES_B -> 1
            SENSOR_3, MOTOR_C, DEGREES_C -> 2
            SENSOR_4 -> 3
        }

    companion object {
        /** The lanes of a robot with a [kind] of brick: sensors, then motors, then their counters. */
        fun of(kind: BrickKind): List<ChartLane> = entries.filter { kind in it.kinds }.sortedBy {
            if (it.isDegrees) {
                2
            } else if (it.isMotor) {
                1
            } else {
                0
            }
        }
    }
}

/** Records the min and the max of each [ChartLane] in equal time intervals, with a bounded number of intervals. */
internal class ChartTrack(private val robots: Int) {
    private val min = IntArray(CAPACITY * robots * LANES)
    private val greatest = IntArray(CAPACITY * robots * LANES)

    /** Length of an interval in milliseconds. */
    var step = RunRecord.LOOK_MILLISECONDS
        private set

    /** Number of intervals started so far. */
    var size = 0
        private set

    fun record(state: SessionState) {
        while (state.milliseconds / step >= CAPACITY) coarsen()
        val piece = (state.milliseconds / step).toInt()
        state.robots.forEachIndexed { robot, now ->
            for (lane in ChartLane.entries) add(piece, place(piece, robot, lane), valueOf(now, lane))
        }
        size = maxOf(size, piece + 1)
    }

    fun cutAt(time: Long) {
        size = minOf(size, (time / step).toInt() + 1)
    }

    fun min(robot: Int, lane: ChartLane, piece: Int): Int = min[place(piece, robot, lane)]

    fun greatest(robot: Int, lane: ChartLane, piece: Int): Int = greatest[place(piece, robot, lane)]

    private fun add(piece: Int, place: Int, value: Int) {
        val isNew = piece >= size
        min[place] = if (isNew) value else minOf(min[place], value)
        greatest[place] = if (isNew) value else maxOf(greatest[place], value)
    }

    private fun place(piece: Int, robot: Int, lane: ChartLane) = (piece * robots + robot) * LANES + lane.ordinal

    /** Merges each two adjacent intervals. */
    private fun coarsen() {
        val width = robots * LANES
        for (piece in 0..<size) {
            for (column in 0..<width) {
                val from = piece * width + column
                val to = piece / 2 * width + column
                min[to] = if (piece % 2 == 0) min[from] else minOf(min[to], min[from])
                greatest[to] = if (piece % 2 == 0) greatest[from] else maxOf(greatest[to], greatest[from])
            }
        }
        size = (size + 1) / 2
        step *= 2
    }

    companion object {
        const val CAPACITY = 4_096
        private val LANES = ChartLane.entries.size

        /** The value of [lane] for [robot]. */
        fun valueOf(robot: RobotSnapshot, lane: ChartLane): Int = when {
            lane.isMotor -> signedPower(robot.brick.motors[lane.port], robot.brick.kind)
            lane.isDegrees -> robot.brick.motorDegrees.getOrElse(lane.port) { 0 }
            else -> robot.brick.inputs.getOrNull(lane.port)?.value ?: 0
        }

        private fun signedPower(motor: MotorState, kind: BrickKind): Int {
            val power = if (kind == BrickKind.RCX) motor.power + 1 else motor.power
            return when (motor.mode) {
                MotorMode.FORWARD -> power
                MotorMode.BACKWARD -> -power
                MotorMode.BRAKE, MotorMode.FLOAT -> 0
            }
        }
    }
}
