package robotran.assignments.grading.workers

import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradedRun
import robotran.assignments.grading.GradingPlan
import robotran.simulation.GoalReport
import robotran.simulation.GoalReportStatus
import robotran.simulation.RunReport
import robotran.simulation.grade.Grade
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.SessionState
import kotlin.math.roundToLong

/** [graded], which is about the attempt [chosen], as a text, for [readGraded]. */
private fun writeGraded(graded: GradedHandIn, chosen: Int, plan: GradingPlan): String = Json.encodeToString(
    GradedText.serializer(),
    when (graded) {
        is GradedHandIn.Graded -> GradedText(
            chosen,
            runs = graded.runs.map { RunText.of(it, plan) },
            end = EndText.of(graded.picture),
        )

        is GradedHandIn.HasErrors -> GradedText(chosen, mistakes = graded.reasons)
        is GradedHandIn.Failed -> GradedText(chosen, failures = graded.reasons)
        is GradedHandIn.Unusable -> error("What cannot be used is not graded.")
    },
)

/** What grading has found out about [submission], as a text, for [readGraded]. */
fun writeGraded(graded: GradedHandIn, submission: Submission.Usable, plan: GradingPlan): String {
    val robot = (graded.submission as? Submission.Usable)?.robot
    return writeGraded(graded, maxOf(0, submission.attempts.indexOfFirst { it.robot == robot }), plan)
}

/**
 * What a [GradingWorker] has found out about [submission]. It lacks what only [GoalProgress.shortfall] has; the reports
 * tell the same in words. The picture is exact to a hundredth of a millimetre.
 *
 * @param text from [GradingWorker.grade] or [writeGraded].
 * @param plan the worker's.
 * @param start the state in which a session in the plan's first world begins.
 * @throws IllegalArgumentException if it is no such text.
 */
fun readGraded(text: String, submission: Submission.Usable, plan: GradingPlan, start: SessionState): GradedHandIn {
    val graded = Json.decodeFromString(GradedText.serializer(), text)
    require(graded.chosen in submission.attempts.indices) { "There is no attempt ${graded.chosen}." }
    val counting = submission.choose(graded.chosen)
    return when {
        graded.mistakes != null -> GradedHandIn.HasErrors(counting, graded.mistakes)
        graded.failures != null -> GradedHandIn.Failed(counting, graded.failures)

        else -> {
            val runs = graded.runs.map { it.runIn(plan) }
            require(graded.end != null && runs.size == plan.runs) { "There are ${runs.size} of ${plan.runs} runs." }
            GradedHandIn.Graded(counting, runs, graded.end.stateAfter(start, runs.first().grade.goals))
        }
    }
}

/** @property chosen the index of the attempt that counts. */
@Serializable
private class GradedText(
    val chosen: Int = 0,
    val mistakes: List<String>? = null,
    val failures: List<String>? = null,
    val runs: List<RunText> = emptyList(),
    val end: EndText? = null,
)

/** @property world its index in the plan. */
@Serializable
private class RunText(
    val world: Int,
    val seed: Int,
    val passed: Boolean,
    val milliseconds: Long,
    val report: RunReport,
) {
    fun runIn(plan: GradingPlan) = GradedRun(
        plan.worlds[world],
        Grade(seed, passed, report.goals.map(::progressOf), milliseconds / MILLISECONDS_PER_SECOND, report),
    )

    companion object {
        fun of(run: GradedRun, plan: GradingPlan): RunText {
            val grade = run.grade
            val milliseconds = (grade.seconds * MILLISECONDS_PER_SECOND).roundToLong()
            return RunText(plan.worlds.indexOf(run.world), grade.seed, grade.passed, milliseconds, grade.report)
        }
    }
}

private fun progressOf(goal: GoalReport): GoalProgress = GoalProgress(
    goal.goal,
    when (goal.status) {
        GoalReportStatus.PENDING -> GoalStatus.PENDING
        GoalReportStatus.MET -> GoalStatus.MET
        GoalReportStatus.FAILED -> GoalStatus.FAILED
    },
    goal.progress,
    goal.parts.map(::progressOf),
)

private const val MILLISECONDS_PER_SECOND = 1000.0
