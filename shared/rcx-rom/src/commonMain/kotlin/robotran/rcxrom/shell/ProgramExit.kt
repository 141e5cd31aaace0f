package robotran.rcxrom.shell

import robotran.rcxrom.controls.MotorMode
import robotran.rcxrom.controls.MotorState
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.ProgramFailure
import robotran.rcxrom.state.RunState

/** How the last run of a program ended, and what a pupil should be told about it. */
internal class ProgramExit(private val messages: BrickMessages) {
    private var motorsBraked = false
    private var isOfThread = false

    var state: RunState = RunState.Idle
        private set

    /** The failure that the display shows until On-Off is pressed. */
    var shownFailure: ProgramFailure? = null
        private set

    /** What the display's numbers mean, or why the robot stands still, where a pupil could not know. */
    val explanation: String?
        get() = shownFailure?.let { if (isOfThread) messages.threadFailureShown(it) else messages.failureShown(it) }
            ?: if (motorsBraked) messages.motorsBrakedAtEnd() else null

    /** A program begins: there is nothing to say about the last one any more. */
    fun forget() {
        motorsBraked = false
    }

    /** Nothing has run since the brick was switched on. */
    fun clear() {
        state = RunState.Idle
        shownFailure = null
        motorsBraked = false
    }

    /**
     * The program ended.
     *
     * @param motors what they did before the firmware braked them.
     */
    fun ended(stopped: Boolean, motors: List<MotorState>) {
        state = RunState.Ended(stopped)
        motorsBraked = !stopped && motors.any { it.mode == MotorMode.FORWARD || it.mode == MotorMode.BACKWARD }
    }

    fun failed(failure: ProgramFailure) {
        state = RunState.Failed(failure)
        shownFailure = failure
        isOfThread = false
    }

    /** A thread of the program cannot go on; the others stand still until [leaveFailure]. */
    fun threadFailed(failure: ProgramFailure) {
        shownFailure = failure
        isOfThread = true
    }

    /** On-Off was pressed: the failure is shown no longer. */
    fun leaveFailure() {
        shownFailure = null
    }
}
