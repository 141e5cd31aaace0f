package robotran.cli.run

import robotran.brick.state.RunState
import robotran.simulation.RecordedInput
import robotran.simulation.Session
import robotran.simulation.SessionInput

/**
 * Applies the button presses and simulates until the last button is up, no program runs and nothing has moved or
 * sounded for [QUIET_MILLISECONDS], or until [milliseconds] have passed.
 */
internal fun Session.runWithPresses(presses: List<ButtonPress>, milliseconds: Int) =
    runWithInputs(inputsOf(presses), milliseconds)

/** The same for any inputs, ordered by time. */
internal fun Session.runWithInputs(inputs: List<RecordedInput>, milliseconds: Int) {
    var quiet = 0
    val waiting = ArrayDeque(inputs)
    while (state.milliseconds < milliseconds && (waiting.isNotEmpty() || quiet < QUIET_MILLISECONDS)) {
        while (waiting.isNotEmpty() && waiting.first().milliseconds <= state.milliseconds) {
            apply(waiting.removeFirst().input)
            quiet = 0
        }
        val before = state
        advance(1)
        val resting =
            state.brick.run !is RunState.Running && !state.brick.sounding && state.robot.pose == before.robot.pose
        quiet = if (resting) quiet + 1 else 0
    }
}

/** At equal times a release comes before a press. */
private fun inputsOf(presses: List<ButtonPress>): List<RecordedInput> {
    val ups = presses.map { RecordedInput(it.until.toLong(), SessionInput.Release(it.button)) }
    val downs = presses.map { RecordedInput(it.from.toLong(), SessionInput.Press(it.button)) }
    return (ups + downs).sortedBy { it.milliseconds }
}

/** Longer than any pause within a system sound of the brick. */
private const val QUIET_MILLISECONDS = 300
