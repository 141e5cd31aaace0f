package robotran.runcontrol

import robotran.rcxrom.program.StepKind
import robotran.simulation.Breakpoint

/** What a run that is being watched is doing. */
sealed interface PlaybackState {
    /** Time stands still. */
    data object Paused : PlaybackState

    /**
     * Time passes.
     *
     * @property until a line to stop before once, beside the breakpoints.
     */
    data class Playing(val until: Breakpoint? = null) : PlaybackState

    /** Time passes until a step of the program is done. */
    data class Stepping(val kind: StepKind) : PlaybackState

    /**
     * On the way to another time, as fast as it goes.
     *
     * @property target in milliseconds.
     * @property then what comes when it is reached.
     */
    data class Seeking(val target: Long, val then: PlaybackState) : PlaybackState
}
