package robotran.legofirmware.task

/** The counters of a task's loops, innermost last. A fifth one takes the place of the fourth. */
internal class LoopCounters {
    private val counters = IntArray(LEVELS)

    var depth = 0
        private set

    /** Returns false if there is no more room, so that the innermost counter is lost. */
    fun push(count: Int): Boolean {
        val hasRoom = depth < LEVELS
        if (hasRoom) depth++
        counters[depth - 1] = count
        return hasRoom
    }

    /** Counts down; false if the loop is over. Null if there is none. */
    fun countDown(): Boolean? {
        if (depth == 0) return null
        counters[depth - 1]--
        if (counters[depth - 1] >= 0) return true
        depth--
        return false
    }

    /** Leaves the loops above [level]. */
    fun unwind(level: Int) {
        depth = minOf(depth, level)
    }

    private companion object {
        const val LEVELS = 4
    }
}
