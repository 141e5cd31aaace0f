package robotran.ui.workshop

import robotran.rom.RunState
import robotran.world.Pose
import robotran.world.SessionState

/** Notices when nothing moves, sounds or is about to, so that time need not go on. */
internal class RestWatch {
    private var quietMilliseconds = 0
    private var pose: Pose? = null

    /** Somebody did something: there may be more to see. */
    fun disturb() {
        quietMilliseconds = 0
    }

    /** [milliseconds] have passed and led to [now]. */
    fun passed(milliseconds: Int, now: SessionState) {
        quietMilliseconds = if (now.robot.pose == pose) quietMilliseconds + milliseconds else 0
        pose = now.robot.pose
    }

    /** Whether time has to go on after [now]. */
    fun isAwake(now: SessionState): Boolean =
        now.brick.run is RunState.Running || now.brick.sounding || quietMilliseconds < SETTLING_MILLISECONDS

    private companion object {
        /** How long nothing must happen; longer than the brick takes for its beeps and its display after a button. */
        const val SETTLING_MILLISECONDS = 500
    }
}
