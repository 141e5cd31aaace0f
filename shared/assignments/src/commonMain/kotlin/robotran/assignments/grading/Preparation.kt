package robotran.assignments.grading

import robotran.assignments.collecting.Submission
import robotran.simulation.RobotLoad

/** The result of compiling a hand-in. */
sealed interface Preparation {
    val submission: Submission

    /** It can run. */
    class Ready internal constructor(
        override val submission: Submission.Usable,
        private val worlds: List<Pair<GradedWorld, List<RobotLoad>>>,
        private val grader: HandInGrader,
    ) : Preparation {
        /** All its runs, in the order of the plan. None has begun. */
        fun runs(): List<PreparedRun> = worlds.flatMapIndexed { index, (graded, loads) ->
            grader.plan.seeds.map { seed ->
                val isFirst = index == 0 && seed == grader.plan.seeds.first
                grader.run(graded, loads, seed, keepsState = isFirst)
            }
        }

        /** What [results] of all of its [runs], in their order, say about the hand-in. */
        fun graded(results: List<RunResult>): GradedHandIn {
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
    data class HasMistakes(override val submission: Submission.Usable, val reasons: List<String>) : Preparation

    /** Robotran itself failed. Each of [reasons] is a line of text. */
    data class Failed(override val submission: Submission.Usable, val reasons: List<String>) : Preparation
}
