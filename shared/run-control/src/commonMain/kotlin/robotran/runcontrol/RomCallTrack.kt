package robotran.runcontrol

import robotran.simulation.state.SessionState

/**
 * Records the number of ROM calls of each robot at the end of equal time intervals, with a bounded number of intervals.
 */
internal class RomCallTrack(private val robots: Int) {
    private val totals = IntArray(CAPACITY * robots)

    /** Length of an interval in milliseconds. */
    var step = RunRecord.LOOK_MILLISECONDS
        private set

    /** Number of intervals started so far. */
    var size = 0
        private set

    fun record(state: SessionState) {
        while (state.milliseconds / step >= CAPACITY) coarsen()
        val piece = (state.milliseconds / step).toInt()
        state.robots.forEachIndexed { robot, now -> totals[piece * robots + robot] = now.romCalls }
        size = maxOf(size, piece + 1)
    }

    fun cutAt(state: SessionState) {
        size = minOf(size, (state.milliseconds / step).toInt())
        record(state)
    }

    /** The calls of [robot] up to the end of interval [piece]; 0 before the first one. */
    fun total(robot: Int, piece: Int): Int = if (piece < 0) 0 else totals[piece * robots + robot]

    /** Merges each two adjacent intervals. */
    private fun coarsen() {
        val pieces = (size + 1) / 2
        for (piece in 0..<pieces) {
            val last = minOf(piece * 2 + 1, size - 1)
            totals.copyInto(totals, piece * robots, last * robots, (last + 1) * robots)
        }
        size = pieces
        step *= 2
    }

    companion object {
        const val CAPACITY = 4_096
    }
}
