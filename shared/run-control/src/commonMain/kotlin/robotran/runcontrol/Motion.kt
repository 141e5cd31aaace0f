package robotran.runcontrol

import robotran.rcxrom.program.StepKind
import robotran.simulation.Breakpoint

/** What a run that is being watched is doing. */
sealed interface Motion {
    /** Time stands still. */
    data object Still : Motion

    /**
     * Time passes.
     *
     * @property until a line to stop before once, beside the breakpoints.
     */
    data class Playing(val until: Breakpoint? = null) : Motion

    /** Time passes until a step of the program is done. */
    data class Stepping(val kind: StepKind) : Motion

    /**
     * On the way to another time, as fast as it goes.
     *
     * @property target in milliseconds.
     * @property then what comes when it is reached.
     */
    data class Seeking(val target: Long, val then: Motion) : Motion
}
