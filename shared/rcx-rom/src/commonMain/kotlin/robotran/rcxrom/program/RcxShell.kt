package robotran.rcxrom.program

import robotran.brick.controls.BrickButton
import robotran.brick.program.DebuggableRun
import robotran.brick.program.RuntimeWarning
import robotran.brick.state.RunState
import robotran.rcxrom.state.RcxFirmwareState

/**
 * The part of a firmware between buttons and programs. It acts on the brick through ROM calls, and does so only in these
 * functions.
 */
interface RcxShell {
    val poweredOn: Boolean

    /** Index of the program that Run starts. */
    val selectedSlot: Int

    val runState: RunState

    /** The warnings of the run, or of the last one if none runs. */
    val warnings: List<RuntimeWarning>

    /** See [robotran.brick.state.BrickState.explanation]. */
    val explanation: String?

    /** Whether the current or last run is of a program that [runSnippet] got. */
    val isSnippet: Boolean

    /** The current run if it can be debugged, otherwise null. */
    val debuggableRun: DebuggableRun?

    /** Whether the program is paused in the middle of its share of this millisecond. */
    val isPaused: Boolean

    /** What the firmware knows now; null for leJOS's. */
    val firmwareState: RcxFirmwareState? get() = null

    /** Starts for the first time, after the firmware was loaded. */
    fun begin()

    fun pressed(button: BrickButton)

    fun released(button: BrickButton)

    /** See [robotran.brick.Brick.stopProgram]. */
    fun stopProgram()

    /** See [robotran.brick.Brick.runSnippet]. */
    fun runSnippet(program: RcxProgram)

    /** Advances by one millisecond, before the program gets its share of it. */
    fun tick()

    /** Runs the program for its share of one millisecond, or for the rest of it after a pause: at most [steps]. */
    fun resumeProgram(steps: Int)
}
