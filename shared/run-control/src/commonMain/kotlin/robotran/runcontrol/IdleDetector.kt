package robotran.runcontrol

import robotran.rcxrom.state.RunState
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
        quietMilliseconds = if (placesNow == places) quietMilliseconds + passed else 0
        milliseconds = now.milliseconds
        places = placesNow
    }

    /** Whether time must continue after [now]. */
    fun isAwake(now: SessionState): Boolean = quietMilliseconds < SETTLING_MILLISECONDS ||
        now.robots.any { it.brick.run is RunState.Running || it.brick.sounding }

    private companion object {
        /** Min time without events; longer than the brick's beeps and display updates after a button press. */
        const val SETTLING_MILLISECONDS = 500
    }
}
