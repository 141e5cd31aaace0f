package robotran.runcontrol

/** The number of a robot's ROM calls over a run, in intervals of [step] milliseconds. */
class CallCountLine internal constructor(private val track: RomCallTrack, private val robot: Int) {
    val step: Long = track.step

    /** Number of intervals. */
    val size: Int = track.size

    /** Number of calls after [from] and up to [until], in milliseconds, each rounded to the end of its interval. */
    fun between(from: Long, until: Long): Int = track.total(robot, pieceAt(until)) - track.total(robot, pieceAt(from))

    private fun pieceAt(milliseconds: Long) = (milliseconds.floorDiv(step)).coerceIn(-1, size - 1L).toInt()
}
