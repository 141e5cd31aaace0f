package robotran.ui.sheet3d

import kotlin.math.abs
import kotlin.math.exp

/**
 * The direction of a camera behind a robot. It follows the robot's heading with a delay, in virtual time, so that the
 * picture does not swing with each turn.
 */
internal class ChaseHeading {
    private var heading: Double? = null
    private var milliseconds = 0L

    /** The direction in degrees at the time [now] of a robot with the direction [wanted]. */
    fun at(wanted: Double, now: Long): Double {
        val before = heading
        val passed = now - milliseconds
        milliseconds = now
        if (before == null || passed < 0 || passed > LONG) return wanted.also { heading = it }
        val way = ((wanted - before) % FULL_TURN + 3 * FULL_TURN / 2) % FULL_TURN - FULL_TURN / 2
        val next = if (abs(way) < LITTLE) wanted else before + way * (1 - exp(-passed / DELAY))
        heading = next
        return next
    }

    private companion object {
        const val FULL_TURN = 360.0
        const val DELAY = 450.0
        const val LITTLE = 0.01

        /** More is no time that has passed, but another one. */
        const val LONG = 1_000L
    }
}
