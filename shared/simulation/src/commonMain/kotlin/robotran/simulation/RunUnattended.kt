package robotran.simulation

import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.state.RunState

/**
 * Presses Run on all bricks and lets time pass with nobody there, until the first robot's program is over and it stands
 * still, or [milliseconds] have passed. The same program in the same world gives the same [report] wherever it is done.
 */
fun Session.runUnattended(milliseconds: Int) {
    pressRun()
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

/** Presses Run on all bricks at once and lets go. */
fun Session.pressRun() {
    for (robot in world.robots.indices) {
        apply(SessionInput.Press(BrickButton.RUN, robot))
        apply(SessionInput.Release(BrickButton.RUN, robot))
    }
}

/** How much time passes between two looks at whether the run is over: several steps of the physics. */
private const val LOOK_MILLISECONDS = 20
