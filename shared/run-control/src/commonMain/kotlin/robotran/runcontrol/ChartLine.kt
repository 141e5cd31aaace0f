package robotran.runcontrol

import robotran.brick.sensors.MeasuringUnit

/** The values of one [lane] of a robot's chart, in intervals of [step] milliseconds from the start of the run. */
class ChartLine internal constructor(private val track: ChartTrack, private val robot: Int, val lane: ChartLane) {
    val step: Long = track.step
    val unit: MeasuringUnit = track.unit(robot, lane)

    /** Number of intervals. */
    val size: Int = track.size

    /** The values in the interval at index [piece]; null if nothing was measured, since no sensor is there or it was off. */
    fun range(piece: Int): IntRange? = track.range(robot, lane, piece)

    /** The index of the interval that contains [milliseconds]; the nearest if there is none. */
    fun pieceAt(milliseconds: Long): Int = (milliseconds / step).coerceIn(0, maxOf(0, size - 1).toLong()).toInt()
}
