package robotran.runcontrol

import robotran.brick.program.StepKind
import robotran.simulation.Breakpoint

/** The playback state of a run. */
sealed interface PlaybackState {
    data object Paused : PlaybackState

    /**
     * Time passes.
     *
     * @property until a line at which to stop once, in addition to the breakpoints.
     */
    data class Playing(val until: Breakpoint? = null) : PlaybackState

    /**
     * Time passes until a step of the program ends.
     *
     * @property thread the number of the thread that steps; null for the current one.
     */
    data class Stepping(val kind: StepKind, val thread: Int? = null) : PlaybackState

    /**
     * Moving to another time, at max speed.
     *
     * @property target in milliseconds.
     * @property then the state after reaching the target.
     */
    data class Seeking(val target: Long, val then: PlaybackState) : PlaybackState
}
