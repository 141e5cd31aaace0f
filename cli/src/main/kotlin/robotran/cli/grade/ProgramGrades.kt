package robotran.cli.grade

import robotran.simulation.grade.Grade
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus

/**
 * What came of one program.
 *
 * @property name its file or link as it was named.
 * @property shownName the same for a person to read.
 */
internal sealed interface ProgramGrades {
    val name: String
    val shownName: String

    /** @property grades one for each seed, in their order; never empty. */
    data class Graded(override val name: String, override val shownName: String, val grades: List<Grade>) :
        ProgramGrades {
        val passed: Int get() = grades.count { it.passed }
    }

    /** It cannot run; each of [reasons] is a line for a person. If it is readable, it has mistakes. */
    data class Rejected(
        override val name: String,
        override val shownName: String,
        val reasons: List<String>,
        val isReadable: Boolean,
    ) : ProgramGrades
}

/** The first goal that is not met and is not made of others; null if all are met. */
internal fun firstUnmet(goals: List<GoalProgress>): GoalProgress? {
    val unmet = goals.firstOrNull { it.status != GoalStatus.MET } ?: return null
    return firstUnmet(unmet.parts) ?: unmet
}

/** How much of it is done, such as `62 %`. */
internal fun percent(goal: GoalProgress): String = "${Math.round(goal.progress * 100)} %"
