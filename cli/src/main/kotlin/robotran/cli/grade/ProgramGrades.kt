package robotran.cli.grade

import robotran.assignments.grading.GradedHandIn
import robotran.language.visibleLine
import robotran.simulation.GoalReport
import robotran.simulation.ReportedShortfall
import robotran.simulation.grade.Grade
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus

/**
 * The result of grading one program.
 *
 * @property name its file or link as the user entered it.
 * @property shownName the display name.
 */
internal sealed interface ProgramGrades {
    val name: String
    val shownName: String

    /**
     * @property grades one per world and seed, in order; never empty.
     * @property worlds the world of each of [grades]: empty for the assignment's own, or the name of a variation.
     */
    data class Success(
        override val name: String,
        override val shownName: String,
        val grades: List<Grade>,
        val worlds: List<String> = grades.map { "" },
    ) : ProgramGrades {
        val passed: Int get() = grades.count { it.passed }
    }

    /** The program cannot run. Each of [reasons] is one line of text. If it is readable, it has errors. */
    data class Failure(
        override val name: String,
        override val shownName: String,
        val reasons: List<String>,
        val isReadable: Boolean,
    ) : ProgramGrades
}

/** [result] as a row called [shownName]. */
internal fun gradesOf(result: GradedHandIn, files: SubmittedFiles, shownName: String): ProgramGrades {
    val submission = result.submission
    val name = files.pathOf(submission.origin) ?: submission.origin
    val shown = visibleLine(shownName)
    return when (result) {
        is GradedHandIn.Graded -> {
            ProgramGrades.Success(name, shown, result.runs.map { it.grade }, result.runs.map { it.world.name })
        }

        is GradedHandIn.HasErrors -> ProgramGrades.Failure(name, shown, result.reasons, isReadable = true)
        is GradedHandIn.Failed -> ProgramGrades.Failure(name, shown, result.reasons, isReadable = false)

        is GradedHandIn.Unusable -> {
            ProgramGrades.Failure(name, shown, listOf(result.submission.reason), isReadable = false)
        }
    }
}

/** The first unmet goal that is not a group of other goals; null if all are met. */
internal fun firstUnmet(goals: List<GoalProgress>): GoalProgress? {
    val unmet = goals.firstOrNull { it.status != GoalStatus.MET } ?: return null
    return firstUnmet(unmet.parts) ?: unmet
}

/** What the run lacked for the goal of [firstUnmet]; null if all are met. */
internal fun firstShortfall(goals: List<GoalReport>): ReportedShortfall? {
    val unmet = goals.firstOrNull { !it.met } ?: return null
    return firstShortfall(unmet.parts) ?: unmet.shortfall
}

/** The progress of the goal, such as `62 %`. */
internal fun percent(goal: GoalProgress): String = percent(goal.progress)

/** A share 0..1 as `62 %`. */
internal fun percent(share: Double): String = "${Math.round(share * 100)} %"
