package robotran.simulation

import robotran.brick.controls.BrickButton
import robotran.brick.state.RunState

/**
 * Presses Run on all bricks and advances time until the first robot's program has ended and the robot stands still, or
 * [milliseconds] have passed. The same program in the same world gives the same [report] on every platform.
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

/** Presses and releases Run on all bricks. */
fun Session.pressRun() {
    for (robot in world.robots.indices) {
        apply(SessionInput.Press(BrickButton.RUN, robot))
        apply(SessionInput.Release(BrickButton.RUN, robot))
    }
}

/** Time between two checks whether the run is over: several physics steps. */
private const val LOOK_MILLISECONDS = 20
