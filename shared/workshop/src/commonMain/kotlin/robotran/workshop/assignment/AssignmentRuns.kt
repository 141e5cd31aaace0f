package robotran.workshop.assignment

import kotlinx.coroutines.withContext
import kotlinx.coroutines.yield
import robotran.assignments.collecting.Submission
import robotran.assignments.doing.HandedInWork
import robotran.assignments.doing.firstPrograms
import robotran.assignments.doing.pupilCopy
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.HandInGrader
import robotran.assignments.grading.Preparation
import robotran.assignments.grading.PreparedRun
import robotran.assignments.grading.RunResult
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.TryResult
import robotran.simulation.RecordedInput
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.startInputs
import robotran.simulation.state.GoalStatus
import robotran.workshop.platform.Platform
import robotran.workshop.service.Preferences
import kotlin.math.roundToLong

/** Runs programs for an assignment without showing them, in slices, so that the screen stays alive. */
internal class AssignmentRuns(
    private val platform: Platform,
    private val physics: PhysicsEngine,
    private val preferences: Preferences,
) {
    /**
     * Runs the programs of the first robot of [project] as Run would start the one at [firstProgram].
     *
     * @param onPart gets the part of the longest possible time that is over.
     */
    suspend fun runOf(project: Project, firstProgram: Int, onPart: (Float) -> Unit): RunOfWork {
        val plain = project.copy(assignment = project.assignment?.copy(checks = null))
        val programs = project.firstPrograms
        val ready = when (val made = prepare(plain, programs, firstProgram)) {
            is Preparation.HasErrors -> return RunOfWork.HasErrors(made.reasons)
            is Preparation.Failed -> return RunOfWork.HasErrors(made.reasons)
            is Preparation.Ready -> made
        }
        val limit = plain.world.timeLimit * MILLISECONDS_PER_SECOND
        val run = ready.runs().first()
        val result = when (val ended = finish(run) { onPart((it.toFloat() / limit).coerceAtMost(1f)) }) {
            is RunResult.Failed -> return RunOfWork.HasErrors(listOf(ended.reason))
            is RunResult.Finished -> ended
        }
        val goals = result.grade.goals
        val inputs = plain.world.startInputs().map { RecordedInput(0, it) }
        return RunOfWork.Ended(
            HandedInWork(
                programs,
                firstProgram,
                inputs,
                TryResult(
                    goals.count { it.status == GoalStatus.MET },
                    goals.size,
                    (result.grade.seconds * MILLISECONDS_PER_SECOND).roundToLong(),
                    result.grade.report.traceHash,
                ),
            ),
        )
    }

    /**
     * Runs [solution] in all worlds and with all seeds of the assignment in [project], and then what pupils begin with,
     * as long as it is a program at all.
     */
    suspend fun check(
        project: Project,
        solution: List<ProjectProgram>,
        onRun: (done: Int, all: Int) -> Unit,
    ): CheckedSolution {
        val ready = when (val made = prepare(project, solution, firstProgram = 0)) {
            is Preparation.HasErrors -> return CheckedSolution.HasErrors(made.reasons)
            is Preparation.Failed -> return CheckedSolution.HasErrors(made.reasons)
            is Preparation.Ready -> made
        }
        val runs = ready.runs()
        val starts = startRuns(project, solution)
        val all = runs.size + starts.size
        val failed = mutableListOf<PreparedRun>()
        runs.forEachIndexed { done, run ->
            onRun(done, all)
            when (val result = finish(run) {}) {
                is RunResult.Failed -> return CheckedSolution.HasErrors(listOf(result.reason))
                is RunResult.Finished -> if (!result.grade.passed) failed += run
            }
        }
        var startPassed = 0
        starts.forEachIndexed { done, run ->
            onRun(runs.size + done, all)
            if ((finish(run) {} as? RunResult.Finished)?.grade?.passed == true) startPassed++
        }
        return CheckedSolution.Checked(
            runs.size,
            failed.size,
            failed.firstOrNull()?.world?.name,
            failed.firstOrNull()?.seed,
            startPassed,
        )
    }

    /** Those of [programs] that reach all goals of the world of [project], each by itself, with the world's own seed. */
    suspend fun solving(project: Project, programs: List<ProjectProgram>): List<ProjectProgram> {
        if (project.world.goals.isEmpty()) return emptyList()
        val plain = project.copy(assignment = project.assignment?.copy(checks = null))
        return programs.filter { program ->
            val run = (prepare(plain, listOf(program), firstProgram = 0) as? Preparation.Ready)?.runs()?.first()
            run != null && (finish(run) {} as? RunResult.Finished)?.grade?.passed == true
        }
    }

    private suspend fun startRuns(project: Project, solution: List<ProjectProgram>): List<PreparedRun> {
        val start = pupilCopy(project).firstPrograms
        val solved = solution.firstOrNull()?.let(::textsOf)
        val first = start.firstOrNull()?.takeUnless { isBlank(it) || textsOf(it) == solved }
        if (first == null) return emptyList()
        return (prepare(project, start, firstProgram = 0) as? Preparation.Ready)?.runs().orEmpty()
    }

    private suspend fun prepare(project: Project, programs: List<ProjectProgram>, firstProgram: Int): Preparation {
        val name = project.world.robots.first().name
        val before = project.robots.firstOrNull { it.name == name } ?: ProjectRobot(name)
        val robot = before.copy(programs = programs, firstProgram = firstProgram)
        val grader = HandInGrader(project, GradingPlan.of(project), physics, preferences.language)
        return withContext(platform.background) { grader.prepare(Submission.Usable("", "", robot)) }
    }

    private suspend fun finish(run: PreparedRun, onTime: (Int) -> Unit): RunResult {
        var milliseconds = 0
        try {
            while (true) {
                withContext(platform.background) { run.advance(SLICE) }?.let { return it }
                milliseconds += SLICE
                onTime(milliseconds)
                yield()
            }
        } finally {
            run.close()
        }
    }

    private companion object {
        /** Virtual milliseconds that take a small part of a frame. */
        const val SLICE = 250
        const val MILLISECONDS_PER_SECOND = 1000
    }
}

/** How running the program in the editor went. */
internal sealed interface RunOfWork {
    data class Ended(val work: HandedInWork) : RunOfWork

    data class HasErrors(val reasons: List<String>) : RunOfWork
}

/** How running the solution with all seeds and variations went. */
internal sealed interface CheckedSolution {
    /**
     * @property world the name of the first variation with a failed run, and its [seed]; null if none failed.
     * @property startPassed the number of runs in which the program to begin with meets all goals, too.
     */
    data class Checked(val runs: Int, val failed: Int, val world: String?, val seed: Int?, val startPassed: Int) :
        CheckedSolution

    data class HasErrors(val reasons: List<String>) : CheckedSolution
}
