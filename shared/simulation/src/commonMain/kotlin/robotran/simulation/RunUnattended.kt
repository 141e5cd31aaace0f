package robotran.simulation

import robotran.brick.state.RunState
import robotran.world.World

/**
 * Presses the start button of all bricks and advances time until the first robot's program has ended and the robot stands still, or
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

/** Presses and releases the start button of all bricks. */
fun Session.pressRun() = world.startInputs().forEach(::apply)

/** The inputs that start the programs of all robots of this world: their start buttons are pressed and released. */
fun World.startInputs(): List<SessionInput> = robots.indices.flatMap { robot ->
    val button = robots[robot].description.brick.startButton
    listOf(SessionInput.Press(button, robot), SessionInput.Release(button, robot))
}

/** Time between two checks whether the run is over: several physics steps. */
private const val LOOK_MILLISECONDS = 20
