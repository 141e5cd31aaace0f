package robotran.runcontrol

/** What one [lane] of a chart shows of a robot, in pieces of [step] milliseconds each from the beginning of the run. */
class ChartLine internal constructor(private val track: ChartTrack, private val robot: Int, val lane: ChartLane) {
    val step: Long = track.step

    /** How many pieces there are. */
    val size: Int = track.size

    /** The least value within the piece with this number. */
    fun min(piece: Int): Int = track.min(robot, lane, piece)

    /** The greatest value within it. */
    fun greatest(piece: Int): Int = track.greatest(robot, lane, piece)

    /** The piece that [milliseconds] is in; the nearest if there is none. */
    fun pieceAt(milliseconds: Long): Int = (milliseconds / step).coerceIn(0, maxOf(0, size - 1).toLong()).toInt()
}
