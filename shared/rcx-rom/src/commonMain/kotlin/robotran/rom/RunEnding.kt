package robotran.rom

/** How the last run of a program ended, and what a pupil should be told about it. */
internal class RunEnding(private val messages: BrickMessages) {
    private var motorsBraked = false

    var state: RunState = RunState.Idle
        private set

    /** The failure that the display shows until On-Off is pressed. */
    var shownFailure: ProgramFailure? = null
        private set

    /** What the display's numbers mean, or why the robot stands still, where a pupil could not know. */
    val explanation: String? get() = shownFailure?.let(messages::failureShown) ?: if (motorsBraked) messages.motorsBrakedAtEnd() else null

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
    }

    /** On-Off was pressed: the failure is shown no longer. */
    fun leaveFailure() {
        shownFailure = null
    }
}
