package robotran.runcontrol

import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
import robotran.world.geometry.Pose

/**
 * Interpolates movements between the physics steps, which are 5 ms apart and visible in slow motion. The result is one
 * step behind.
 */
internal class SmoothMotion {
    private var before: SessionState? = null
    private var now: SessionState? = null

    /** The time of the next physics step after [milliseconds]. */
    fun nextStep(milliseconds: Long): Long = milliseconds - milliseconds % STEP + STEP

    /** Call with every state right after a physics step. */
    fun record(state: SessionState) {
        if (state.milliseconds % STEP != 0L || state.milliseconds == now?.milliseconds) return
        before = now
        now = state
    }

    /** Call when the run jumps to another time. */
    fun jump() {
        before = null
        now = null
    }

    /** [state] with positions interpolated to this [fraction] of the next millisecond. */
    fun at(state: SessionState, fraction: Double): SessionState {
        val to = now ?: return state
        val from = before ?: return state
        if (to.milliseconds != state.milliseconds - state.milliseconds % STEP ||
            from.milliseconds != to.milliseconds - STEP
        ) {
            return state
        }
        val share = (state.milliseconds - to.milliseconds + fraction) / STEP
        return state.copy(
            robots = state.robots.mapIndexed { number, robot ->
                robot.copy(robot = between(from.robots[number].robot, to.robots[number].robot, share, robot.robot))
            },
            blocks = state.blocks.indices.map { between(from.blocks[it], to.blocks[it], share) },
        )
    }

    private fun between(from: RobotState, to: RobotState, share: Double, now: RobotState) = now.copy(
        pose = between(from.pose, to.pose, share),
        leftWheelTurn = between(from.leftWheelTurn, to.leftWheelTurn, share),
        rightWheelTurn = between(from.rightWheelTurn, to.rightWheelTurn, share),
    )

    private fun between(from: Pose, to: Pose, share: Double): Pose {
        var turn = to.heading - from.heading
        if (turn > HALF_TURN) turn -= 2 * HALF_TURN
        if (turn < -HALF_TURN) turn += 2 * HALF_TURN
        return Pose(between(from.x, to.x, share), between(from.y, to.y, share), from.heading + turn * share)
    }

    private fun between(from: Double, to: Double, share: Double) = from + (to - from) * share

    private companion object {
        /** Milliseconds between two physics steps. */
        const val STEP = 5L
        const val HALF_TURN = 180.0
    }
}
