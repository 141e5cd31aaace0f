package robotran.runcontrol

import robotran.rcxrom.controls.MotorMode
import robotran.rcxrom.controls.MotorState
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState

/** What a chart shows of a robot over time: its sensors as their ports show them, and what its motors are told. */
enum class ChartLane {
    SENSOR_1,
    SENSOR_2,
    SENSOR_3,

    /**
     * The power and one more, 1..8 forwards and -1..-8 backwards; 0 if the motor is not driven, which is less than
     * driven with power 0.
     */
    MOTOR_A,
    MOTOR_B,
    MOTOR_C,
    ;

    val isMotor: Boolean get() = this >= MOTOR_A
}

/**
 * The least and the greatest value of one [ChartLane] in each of many equal pieces of time, with as many pieces as
 * there is room for.
 */
internal class ChartTrack(private val robots: Int) {
    private val min = IntArray(CAPACITY * robots * LANES)
    private val greatest = IntArray(CAPACITY * robots * LANES)

    /** Milliseconds that a piece lasts. */
    var step = RunRecord.LOOK_MILLISECONDS
        private set

    /** How many pieces have been begun. */
    var size = 0
        private set

    fun look(state: SessionState) {
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

    /** The least value of [lane] in [piece]. */
    fun min(robot: Int, lane: ChartLane, piece: Int): Int = min[place(piece, robot, lane)]

    fun greatest(robot: Int, lane: ChartLane, piece: Int): Int = greatest[place(piece, robot, lane)]

    private fun add(piece: Int, place: Int, value: Int) {
        val isNew = piece >= size
        min[place] = if (isNew) value else minOf(min[place], value)
        greatest[place] = if (isNew) value else maxOf(greatest[place], value)
    }

    private fun place(piece: Int, robot: Int, lane: ChartLane) = (piece * robots + robot) * LANES + lane.ordinal

    /** Makes one piece of every two. */
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

        /** What [lane] has to show of [robot]. */
        fun valueOf(robot: RobotSnapshot, lane: ChartLane): Int = if (lane.isMotor) {
            signedPower(robot.brick.motors[lane.ordinal - ChartLane.MOTOR_A.ordinal])
        } else {
            robot.brick.sensors[lane.ordinal].value
        }

        private fun signedPower(motor: MotorState): Int = when (motor.mode) {
            MotorMode.FORWARD -> motor.power + 1
            MotorMode.BACKWARD -> -motor.power - 1
            MotorMode.BRAKE, MotorMode.FLOAT -> 0
        }
    }
}
