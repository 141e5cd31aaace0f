package robotran.assignments.grading

import robotran.assignments.collecting.Submission
import robotran.simulation.RobotProgramSet

/** The result of compiling a hand-in. */
sealed interface Preparation {
    val submission: Submission

    /** It can run, or something that may count in its place can. */
    class Ready internal constructor(
        override val submission: Submission.Usable,
        private val attempts: List<PreparedAttempt>,
        private val grader: HandInGrader,
    ) : Preparation {
        private val running: List<IndexedValue<PreparedAttempt.Ready>> =
            attempts.withIndex().mapNotNull { (index, attempt) ->
                (attempt as? PreparedAttempt.Ready)?.let { IndexedValue(index, it) }
            }

        /** All its runs, in the order of the plan, once for each attempt that can run. None has begun. */
        fun runs(): List<PreparedRun> = running.flatMap { (_, attempt) -> runs(attempt) }

        /** What [results] of all of its [runs], in their order, say about the hand-in: about the best attempt. */
        fun graded(results: List<RunResult>): GradedHandIn {
            val graded = results.chunked(results.size / running.size).zip(running) { ofOne, (index, _) ->
                graded(submission.choose(index), ofOne)
            }
            return graded.filterIsInstance<GradedHandIn.Graded>().maxWithOrNull(BETTER) ?: graded.first()
        }

        private fun runs(attempt: PreparedAttempt.Ready) = attempt.worlds.flatMapIndexed { index, (graded, loads) ->
            grader.plan.seeds.map { seed ->
                val isFirst = index == 0 && seed == grader.plan.seeds.first
                grader.run(graded, loads, seed, keepsState = isFirst)
            }
        }

        private fun graded(submission: Submission.Usable, results: List<RunResult>): GradedHandIn {
            val failed = results.filterIsInstance<RunResult.Failed>()
            if (failed.isNotEmpty()) return GradedHandIn.Failed(submission, failed.map { it.reason }.distinct())
            val finished = results.filterIsInstance<RunResult.Finished>()
            return GradedHandIn.Graded(
                submission,
                finished.map { GradedRun(it.world, it.grade) },
                checkNotNull(finished.first().state) { "The first run keeps its state." },
            )
        }
    }

    /** Each of [reasons] is a line of text. */
    data class HasErrors(override val submission: Submission.Usable, val reasons: List<String>) : Preparation

    /** Robotran itself failed. Each of [reasons] is a line of text. */
    data class Failed(override val submission: Submission.Usable, val reasons: List<String>) : Preparation
}

/** One of several things that may count of a hand-in, compiled. */
internal sealed interface PreparedAttempt {
    class Ready(val worlds: List<Pair<GradedWorld, List<RobotProgramSet>>>) : PreparedAttempt

    class HasErrors(val reasons: List<String>) : PreparedAttempt

    class Failed(val reasons: List<String>) : PreparedAttempt
}

/** What comes of [submission] if none of its attempts can run. */
internal fun PreparedAttempt.unready(submission: Submission.Usable): Preparation = when (this) {
    is PreparedAttempt.HasErrors -> Preparation.HasErrors(submission, reasons)
    is PreparedAttempt.Failed -> Preparation.Failed(submission, reasons)
    is PreparedAttempt.Ready -> error("It can run.")
}

/** More runs that met all goals, or else more goals, or else nearer to them, or else quicker. */
private val BETTER = compareBy<GradedHandIn.Graded>(
    { it.met },
    { it.goalsMet },
    { graded -> graded.runs.sumOf { run -> run.grade.goals.sumOf { it.progress } } },
    { -(it.seconds ?: 0.0) },
)
