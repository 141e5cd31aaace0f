package robotran.runcontrol

import robotran.brick.state.RunState
import robotran.simulation.state.SessionState
import robotran.world.geometry.Pose

/** Detects that nothing moves, sounds or is about to, so that time may stop. */
class IdleDetector {
    private var quietMilliseconds = 0L
    private var milliseconds = 0L
    private var places: List<Pose> = emptyList()

    /** Restarts the detection after user input. */
    fun disturb() {
        quietMilliseconds = 0
    }

    /** Records that time has passed and led to [now]. */
    fun passed(now: SessionState) {
        val placesNow = now.robots.map { it.robot.pose } + now.blocks
        val passed = (now.milliseconds - milliseconds).coerceAtLeast(0)
        // A robot that stands while its program runs is not idle: after the program its goals are still to be decided.
        quietMilliseconds = if (placesNow == places && !isBusy(now)) quietMilliseconds + passed else 0
        milliseconds = now.milliseconds
        places = placesNow
    }

    /** Whether time must continue after [now]. */
    fun isAwake(now: SessionState): Boolean = quietMilliseconds < SETTLING_MILLISECONDS || isBusy(now)

    private fun isBusy(now: SessionState) = now.robots.any { it.brick.run is RunState.Running || it.brick.sounding }

    private companion object {
        /**
         * Min time without events; longer than the brick's beeps and display updates after a button press, and than
         * the time after which [RunEndDetector] decides the goals.
         */
        const val SETTLING_MILLISECONDS = 500
    }
}
