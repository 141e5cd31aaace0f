package robotran.runcontrol

import robotran.rcxrom.state.RunState
import robotran.simulation.state.SessionState
import robotran.world.geometry.Pose

/** Notices when nothing moves, sounds or is about to, so that time need not go on. */
class IdleDetector {
    private var quietMilliseconds = 0L
    private var milliseconds = 0L
    private var places: List<Pose> = emptyList()

    /** Somebody did something: there may be more to see. */
    fun disturb() {
        quietMilliseconds = 0
    }

    /** Time has passed and led to [now]. */
    fun passed(now: SessionState) {
        val placesNow = now.robots.map { it.robot.pose } + now.blocks
        val passed = (now.milliseconds - milliseconds).coerceAtLeast(0)
        quietMilliseconds = if (placesNow == places) quietMilliseconds + passed else 0
        milliseconds = now.milliseconds
        places = placesNow
    }

    /** Whether time has to go on after [now]. */
    fun isAwake(now: SessionState): Boolean = quietMilliseconds < SETTLING_MILLISECONDS ||
        now.robots.any { it.brick.run is RunState.Running || it.brick.sounding }

    private companion object {
        /** How long nothing must happen; longer than the brick takes for its beeps and its display after a button. */
        const val SETTLING_MILLISECONDS = 500
    }
}
