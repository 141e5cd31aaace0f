package robotran.assignments.grading

import robotran.projects.Project
import robotran.world.World

/**
 * A world in which hand-ins are graded.
 *
 * @property name of the variation; empty for the assignment's own world.
 */
data class GradedWorld(val name: String, val world: World)

/**
 * The runs by which each hand-in is graded: every one of [worlds] with every one of [seeds].
 *
 * @property worlds the assignment's own first.
 */
data class GradingPlan(val worlds: List<GradedWorld>, val seeds: IntRange) {
    /** The number of runs of one hand-in. */
    val runs: Int get() = worlds.size * seeds.count()

    companion object {
        /**
         * The plan of [assignment]: what its checks say, or else its world with its own seed.
         *
         * @param seeds replaces the seeds of the assignment.
         */
        fun of(assignment: Project, seeds: IntRange? = null): GradingPlan {
            val world = assignment.worldToRun
            val checks = assignment.assignment?.checks
            return GradingPlan(
                listOf(GradedWorld("", world)) + checks?.variations.orEmpty().map { GradedWorld(it.name, it.world) },
                seeds ?: checks?.seeds ?: world.seed..world.seed,
            )
        }
    }
}
