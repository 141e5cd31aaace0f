package robotran.assignments.grading

import robotran.simulation.Session
import robotran.simulation.grade.GoalRun
import robotran.simulation.grade.Grade
import robotran.simulation.state.SessionState

/**
 * A run of grading, which begins with the first [advance].
 *
 * @param keepsState whether the result has the end of the run, which takes much memory.
 */
class PreparedRun internal constructor(
    val world: GradedWorld,
    val seed: Int,
    private val keepsState: Boolean,
    private val begin: () -> Session,
    private val runOf: (Session) -> GoalRun,
    private val reasonOf: (Throwable) -> String,
) {
    private var session: Session? = null
    private var run: GoalRun? = null

    /** Runs for at most [milliseconds] of virtual time; returns the result once the run is over. Never fails. */
    fun advance(milliseconds: Int): RunResult? = try {
        val session = session ?: begin().also { session = it }
        val run = run ?: runOf(session).also { run = it }
        run.advance(milliseconds)
        if (run.isOver) finished(run, session).also { close() } else null
    } catch (problem: Throwable) {
        // A hand-in must not stop the grading of the others.
        close()
        RunResult.Failed(reasonOf(problem))
    }

    private fun finished(run: GoalRun, session: Session): RunResult {
        val grade = run.grade()
        return RunResult.Finished(world, grade, session.state.takeIf { keepsState })
    }

    /** Runs to the end. */
    fun finish(): RunResult {
        while (true) advance(Int.MAX_VALUE)?.let { return it }
    }

    /** Ends the run without a result; does nothing if it is over. */
    fun close() {
        session?.close()
        session = null
        run = null
    }
}

/** The result of a [PreparedRun]. */
sealed interface RunResult {
    /** @property state the end of the run, to be drawn; only of the first run of a hand-in. */
    class Finished(val world: GradedWorld, val grade: Grade, val state: SessionState?) : RunResult

    /** Robotran itself failed; [reason] is a line of text. */
    data class Failed(val reason: String) : RunResult
}
