package robotran.runcontrol

/** How many ROM calls a robot makes over a run, in pieces of [step] milliseconds each. */
class RomCallLine internal constructor(private val track: RomCallTrack, private val robot: Int) {
    val step: Long = track.step

    /** How many pieces there are. */
    val size: Int = track.size

    /**
     * How many calls were made after [from] and up to [until], in milliseconds, each taken for the end of the piece
     * that it is in.
     */
    fun between(from: Long, until: Long): Int = track.total(robot, pieceAt(until)) - track.total(robot, pieceAt(from))

    private fun pieceAt(milliseconds: Long) = (milliseconds.floorDiv(step)).coerceIn(-1, size - 1L).toInt()
}
