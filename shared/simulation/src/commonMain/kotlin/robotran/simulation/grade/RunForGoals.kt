package robotran.simulation.grade

import robotran.brick.state.RunState
import robotran.simulation.Session
import robotran.simulation.pressRun
import robotran.simulation.report
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.SessionState

/**
 * Presses Run on every robot and advances time without further input, until
 * - all goals of the world are finally decided, if [endsWhenDecided], or
 * - the first robot's program has ended and nothing has moved or sounded for [QUIET_MILLISECONDS], or
 * - [milliseconds] have passed.
 *
 * Then the run ends and its goals are evaluated. The same programs in the same world give the same grade on every
 * platform.
 *
 * @param milliseconds default: the world's time limit.
 */
fun Session.runForGoals(
    milliseconds: Int = world.timeLimit * MILLISECONDS_PER_SECOND,
    endsWhenDecided: Boolean = true,
): Grade {
    val run = GoalRun(this, milliseconds, endsWhenDecided)
    while (!run.isOver) run.advance(milliseconds)
    return run.grade()
}

/**
 * The run of [runForGoals] in slices, so that a screen stays alive meanwhile. The slices do not affect the result.
 *
 * @param session must be new, and belongs to this run.
 */
class GoalRun(
    private val session: Session,
    milliseconds: Int = session.world.timeLimit * MILLISECONDS_PER_SECOND,
    private val endsWhenDecided: Boolean = true,
) {
    private var left = milliseconds
    private var quiet = 0

    init {
        session.pressRun()
    }

    val isOver: Boolean
        get() = left <= 0 || quiet >= QUIET_MILLISECONDS || (endsWhenDecided && session.areGoalsDecided())

    /** Advances time by at most [milliseconds], rounded up to [LOOK_MILLISECONDS], and not beyond the end of the run. */
    fun advance(milliseconds: Int) {
        var rest = milliseconds
        while (rest > 0 && !isOver) {
            val before = session.state
            val part = minOf(left, LOOK_MILLISECONDS)
            session.advance(part)
            left -= part
            rest -= part
            val now = session.state
            quiet =
                if (isOver(now) && !hasMoved(before, now) && now.robots.none { it.brick.sounding }) quiet + part else 0
        }
    }

    /** Ends the run and evaluates its goals. */
    fun grade(): Grade {
        session.finish()
        val goals = session.state.goals
        return Grade(
            seed = session.world.seed,
            passed = goals.isNotEmpty() && goals.all { it.status == GoalStatus.MET },
            goals = goals,
            seconds = session.state.milliseconds / MILLISECONDS_PER_SECOND.toDouble(),
            report = session.report(),
        )
    }
}

private fun Session.areGoalsDecided(): Boolean {
    val goals = state.goals
    return goals.isNotEmpty() && goals.none { it.status == GoalStatus.PENDING }
}

private fun isOver(state: SessionState): Boolean = state.brick.run !is RunState.Running

private fun hasMoved(before: SessionState, after: SessionState): Boolean =
    before.blocks != after.blocks || before.robots.map { it.robot.pose } != after.robots.map { it.robot.pose }

private const val MILLISECONDS_PER_SECOND = 1000

/** Time between two checks: several physics steps. */
private const val LOOK_MILLISECONDS = 20

/** Longer than any pause within a sound. */
private const val QUIET_MILLISECONDS = 300
