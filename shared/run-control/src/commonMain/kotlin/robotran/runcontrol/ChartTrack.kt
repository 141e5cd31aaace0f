package robotran.runcontrol

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.controls.PowerUnit
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.MeasuringUnit
import robotran.brick.sensors.SensorKind
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState
import robotran.world.RobotDescription

/** Records the min and the max of each [ChartLane] in equal time intervals, with a bounded number of intervals. */
internal class ChartTrack(private val descriptions: List<RobotDescription>) {
    private val robots = descriptions.size

    /** What is plugged into the ports of each robot, whatever its program chose; null where the brick does not tell. */
    private val kinds: List<List<SensorKind?>> = descriptions.map { robot ->
        List(robot.brick.inputPorts) { port ->
            robot.parts.firstOrNull { it.port == port + 1 }?.kind.takeIf { robot.brick.readsInUnits }
        }
    }
    private val lanes = descriptions.flatMap { ChartLane.of(it) }.distinct()
    private val columns = IntArray(ChartLane.entries.size) { lanes.indexOf(ChartLane.entries[it]) }
    private val min = IntArray(CAPACITY * robots * lanes.size)
    private val greatest = IntArray(CAPACITY * robots * lanes.size)

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
            for (lane in lanes) {
                add(piece, place(piece, robot, lane), valueOf(now, lane, kindOf(robot, lane)))
            }
        }
        size = maxOf(size, piece + 1)
    }

    fun cutAt(time: Long) {
        size = minOf(size, (time / step).toInt() + 1)
    }

    fun unit(robot: Int, lane: ChartLane): MeasuringUnit = when {
        lane.isDegrees -> MeasuringUnit.DEGREES
        lane == ChartLane.BATTERY -> MeasuringUnit.MILLIVOLTS
        lane.isMotor -> if (powerUnitOf(robot) == PowerUnit.PERCENT) MeasuringUnit.PERCENT else MeasuringUnit.NONE
        else -> MeasuringUnit.of(kindOf(robot, lane))
    }

    private fun powerUnitOf(robot: Int): PowerUnit = descriptions[robot].brick.powerUnit

    /** Null if nothing was measured. */
    fun range(robot: Int, lane: ChartLane, piece: Int): IntRange? {
        if (columns[lane.ordinal] < 0) return null
        val place = place(piece, robot, lane)
        return (min[place]..greatest[place]).takeUnless { it.isEmpty() }
    }

    private fun kindOf(robot: Int, lane: ChartLane): SensorKind? =
        if (lane.isSensor) kinds[robot].getOrNull(lane.port) else null

    /** A piece without values has a min that is greater than its max. */
    private fun add(piece: Int, index: Int, value: Int?) {
        val isNew = piece >= size
        min[index] = minOf(if (isNew) Int.MAX_VALUE else min[index], value ?: Int.MAX_VALUE)
        greatest[index] = maxOf(if (isNew) Int.MIN_VALUE else greatest[index], value ?: Int.MIN_VALUE)
    }

    private fun place(piece: Int, robot: Int, lane: ChartLane) =
        (piece * robots + robot) * lanes.size + columns[lane.ordinal]

    /** Merges each two adjacent intervals. */
    private fun coarsen() {
        val width = robots * lanes.size
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

        /**
         * The value of [lane] for [robot], in the unit of a sensor of this [kind], or in that of the program where the brick does not tell;
         * null if nothing is measured.
         */
        fun valueOf(robot: RobotSnapshot, lane: ChartLane, kind: SensorKind?): Int? = when {
            lane.isMotor -> robot.brick.motors.getOrNull(lane.port)?.let { signedPower(it, robot.brick.kind) }
            lane.isDegrees -> robot.brick.motorDegrees.getOrElse(lane.port) { 0 }
            lane == ChartLane.BATTERY -> robot.brick.batteryMillivolts
            kind != null -> robot.brick.inputs.getOrNull(lane.port)?.measured(kind)
            else -> robot.brick.inputs.getOrNull(lane.port)?.value.takeIf { !robot.brick.kind.readsInUnits }
        }

        private fun signedPower(motor: MotorState, kind: BrickKind): Int {
            val power = if (kind.powerUnit == PowerUnit.STEPS) motor.power + 1 else motor.power
            return when (motor.mode) {
                MotorMode.FORWARD -> power
                MotorMode.BACKWARD -> -power
                MotorMode.BRAKE, MotorMode.FLOAT -> 0
            }
        }
    }
}
