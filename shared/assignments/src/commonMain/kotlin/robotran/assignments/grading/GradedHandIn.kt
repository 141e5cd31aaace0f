package robotran.assignments.grading

import robotran.assignments.collecting.Submission
import robotran.simulation.grade.Grade
import robotran.simulation.state.SessionState

/** What grading found out about [submission]. */
sealed interface GradedHandIn {
    val submission: Submission

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

        /** The runs in the world called [name]. */
        fun runsIn(name: String): List<GradedRun> = runs.filter { it.world.name == name }

        /** The mean virtual time of the runs that met all goals; null if none did. */
        val seconds: Double? get() = runs.filter { it.grade.passed }.map { it.grade.seconds }.average().takeIf { !it.isNaN() }
    }

    /** Its programs cannot run: they have mistakes. Each of [reasons] is a line of text. */
    data class HasMistakes(override val submission: Submission.Usable, val reasons: List<String>) : GradedHandIn

    /** Robotran itself failed with it. Each of [reasons] is a line of text. */
    data class Failed(override val submission: Submission.Usable, val reasons: List<String>) : GradedHandIn

    /** Nothing in it can be used. */
    data class Unusable(override val submission: Submission.Unusable) : GradedHandIn
}

/** One run: [grade] in [world], with the seed of [grade]. */
data class GradedRun(val world: GradedWorld, val grade: Grade)
