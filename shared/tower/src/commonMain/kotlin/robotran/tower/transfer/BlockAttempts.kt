package robotran.tower.transfer

import robotran.tower.Tries
import robotran.tower.line.Attempt
import robotran.tower.line.Failures

/**
 * The attempts in vain to send one block.
 *
 * @param invested what beginning again would throw away, in ms.
 */
internal class BlockAttempts(private val invested: Int) {
    val failures = Failures()
    var count = 0
        private set

    /** The time of all attempts, in ms. */
    var wasted = 0
        private set

    /** The time since the brick was last heard, in ms. */
    var unheard = 0
        private set

    /**
     * A block keeps its size, so a large one may never get through. Beginning again with smaller ones pays once as much
     * time is lost with this one as that would cost.
     */
    fun areTooMany(isSmallest: Boolean): Boolean =
        if (isSmallest) count >= Tries.SMALLEST_BLOCK else count >= Tries.BLOCK && wasted >= invested

    fun add(attempt: Attempt.Unanswered, duration: Int) {
        failures.add(attempt)
        count++
        wasted += duration
        unheard = if (attempt.brickHeard) 0 else unheard + duration
    }

    fun brickIsAlive() {
        unheard = 0
    }
}
