package robotran.world

import robotran.rom.BrickButton
import robotran.rom.RunState

/**
 * Presses Run on the brick and lets time pass with nobody there, until the program is over and the robot stands still, or
 * [milliseconds] have passed. The same program in the same world gives the same [report] wherever it is done.
 */
fun Session.runUnattended(milliseconds: Int) {
    apply(SessionInput.Press(BrickButton.RUN))
    apply(SessionInput.Release(BrickButton.RUN))
    var left = milliseconds
    while (left > 0) {
        val before = state
        val part = minOf(left, LOOK_MILLISECONDS)
        advance(part)
        left -= part
        val over = state.brick.run is RunState.Ended || state.brick.run is RunState.Failed
        if (over && state.robot.pose == before.robot.pose) return
    }
}

/** How much time passes between two looks at whether the run is over: several steps of the physics. */
private const val LOOK_MILLISECONDS = 20
