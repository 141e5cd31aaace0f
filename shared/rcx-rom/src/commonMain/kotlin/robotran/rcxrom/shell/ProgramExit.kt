package robotran.rcxrom.shell

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.program.ProgramFailure
import robotran.brick.state.RunState
import robotran.rcxrom.messages.BrickMessages

/** How the last run of a program ended, and its explanation for the pupil. */
internal class ProgramExit(private val messages: BrickMessages) {
    private var motorsBraked = false
    private var isThreadFailure = false

    var state: RunState = RunState.Idle
        private set

    /** The failure that the display shows until On-Off is pressed. */
    var shownFailure: ProgramFailure? = null
        private set

    /** Explains the numbers on the display, or why the robot stopped; null if neither needs an explanation. */
    val explanation: String?
        get() = shownFailure?.let {
            if (isThreadFailure) messages.threadFailureShown(it) else messages.failureShown(it)
        }
            ?: if (motorsBraked) messages.motorsBrakedAtEnd() else null

    /** Clears the explanation of the last run when a program starts. */
    fun forget() {
        motorsBraked = false
    }

    /** Resets to the state of a brick that was just switched on. */
    fun clear() {
        state = RunState.Idle
        shownFailure = null
        motorsBraked = false
    }

    /**
     * Records that the program ended.
     *
     * @param motors their state before the firmware braked them.
     */
    fun ended(stopped: Boolean, motors: List<MotorState>) {
        state = RunState.Ended(stopped)
        motorsBraked = !stopped && motors.any { it.mode == MotorMode.FORWARD || it.mode == MotorMode.BACKWARD }
    }

    fun failed(failure: ProgramFailure) {
        state = RunState.Failed(failure)
        shownFailure = failure
        isThreadFailure = false
    }

    /** Records that a thread failed; the others stand still until [leaveFailure]. */
    fun threadFailed(failure: ProgramFailure) {
        shownFailure = failure
        isThreadFailure = true
    }

    /** Clears the displayed failure after On-Off was pressed. */
    fun leaveFailure() {
        shownFailure = null
    }
}
