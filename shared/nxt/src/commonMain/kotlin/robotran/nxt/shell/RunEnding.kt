package robotran.nxt.shell

import robotran.brick.program.ProgramFailure
import robotran.brick.state.RunState
import robotran.nxt.messages.NxtMessages

/** How the last run of a program ended, and what explains it to the pupil. */
internal class RunEnding(private val messages: NxtMessages) {
    private var motorsRoll = false
    private var isThreadFailure = false

    var state: RunState = RunState.Idle
        private set

    /** The failure that the display shows until ESCAPE is pressed. */
    var shownFailure: ProgramFailure? = null
        private set

    /** Explains the display, or why the robot stopped; null if neither needs an explanation. */
    val explanation: String?
        get() {
            val failure = shownFailure
            return when {
                failure == null -> if (motorsRoll) messages.motorsRollAtEnd() else null
                isThreadFailure -> messages.threadFailureShown(failure)
                else -> messages.failureShown(failure)
            }
        }

    /** Forgets the explanation of the last run when a program starts. */
    fun forget() {
        motorsRoll = false
    }

    /** Back to the state of a brick that was just switched on. */
    fun clear() {
        state = RunState.Idle
        shownFailure = null
        motorsRoll = false
    }

    /** @param wasDriving whether a motor was driven until the end. */
    fun ended(stopped: Boolean, wasDriving: Boolean) {
        state = RunState.Ended(stopped)
        shownFailure = null
        motorsRoll = wasDriving && !stopped
    }

    fun failed(failure: ProgramFailure) {
        state = RunState.Failed(failure)
        shownFailure = failure
        isThreadFailure = false
    }

    /** A thread failed; the others stand still until [leaveFailure]. */
    fun threadFailed(failure: ProgramFailure) {
        shownFailure = failure
        isThreadFailure = true
    }

    fun leaveFailure() {
        shownFailure = null
    }
}
