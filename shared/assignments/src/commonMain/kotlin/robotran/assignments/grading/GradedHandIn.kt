package robotran.assignments.grading

import robotran.assignments.collecting.Submission
import robotran.simulation.grade.Grade
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.SessionState

/** What grading found out about [submission]. */
sealed interface GradedHandIn {
    val submission: Submission
    val verdict: Verdict

    /**
     * Its programs were run.
     *
     * @property runs one for each world and seed of the plan, in its order.
     * @property picture the end of the first run, to be drawn.
     */
    data class Graded(
        override val submission: Submission.Usable,
        val runs: List<GradedRun>,
        val picture: SessionState,
    ) : GradedHandIn {
        val met: Int get() = runs.count { it.grade.passed }
        val hasPassed: Boolean get() = met == runs.size

        override val verdict: Verdict get() = when (met) {
            runs.size -> Verdict.PASSED
            0 -> Verdict.MISSED
            else -> Verdict.PARTLY
        }

        /** The number of goals of the assignment's own world. */
        val goals: Int get() = runs.first().grade.goals.size

        /** The number of these goals that the best run in that world met. */
        val goalsMet: Int get() = ownRuns.maxOf { run -> run.grade.goals.count { it.status == GoalStatus.MET } }

        /** The number of these goals that all runs in that world met. */
        val goalsMetAlways: Int get() = runs.first().grade.goals.indices.count { goal ->
            ownRuns.all { it.grade.goals[goal].status == GoalStatus.MET }
        }

        private val ownRuns: List<GradedRun> get() = runsIn(runs.first().world.name)

        /** The runs in the world called [name]. */
        fun runsIn(name: String): List<GradedRun> = runs.filter { it.world.name == name }

        /** The mean virtual time of the runs that met all goals; null if none did. */
        val seconds: Double? get() = runs.filter {
            it.grade.passed
        }.map { it.grade.seconds }.average().takeIf { !it.isNaN() }
    }

    /** Its programs cannot run: they have mistakes. Each of [reasons] is a line of text. */
    data class HasErrors(override val submission: Submission.Usable, val reasons: List<String>) : GradedHandIn {
        override val verdict: Verdict get() = Verdict.MISTAKES
    }

    /** Robotran itself failed with it. Each of [reasons] is a line of text. */
    data class Failed(override val submission: Submission.Usable, val reasons: List<String>) : GradedHandIn {
        override val verdict: Verdict get() = Verdict.FAILED
    }

    /** Nothing in it can be used. */
    data class Unusable(override val submission: Submission.Unusable) : GradedHandIn {
        override val verdict: Verdict get() = Verdict.UNUSABLE
    }
}

/** The result of grading in one word. */
enum class Verdict {
    /** All runs met all goals. */
    PASSED,

    /** Some runs did. */
    PARTLY,

    /** None did. */
    MISSED,

    /** The programs cannot run. */
    MISTAKES,

    /** Robotran itself failed. */
    FAILED,

    /** There is nothing to run. */
    UNUSABLE,
}

/** One run: [grade] in [world], with the seed of [grade]. */
data class GradedRun(val world: GradedWorld, val grade: Grade)
