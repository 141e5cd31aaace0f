package robotran.cli.grade

import kotlinx.coroutines.runBlocking
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradedWorld
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.HandInGrader
import robotran.assignments.grading.PreparedRun
import robotran.assignments.grading.RunResult
import robotran.assignments.grading.gradeAll
import robotran.cli.console.messages
import robotran.cli.files.ProgramFiles
import robotran.cli.files.readProgramFiles
import robotran.cli.input.LoadedWorld
import robotran.cli.input.WorldChanges
import robotran.cli.input.robotsAreFinished
import robotran.console.Console
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.simulation.physics.loadPhysicsEngine
import java.util.concurrent.Executors

/** An assignment, and the runs by which hand-ins for it are graded. */
internal data class GradingTask(val assignment: Project, val plan: GradingPlan)

/** Grades hand-ins for assignments as the options of a request say. */
internal class GradingTasks(private val console: Console) {
    private val messages = console.messages

    /** The task of [place]. On error prints it and returns null. */
    fun taskFor(place: LoadedWorld, request: GradeRequest): GradingTask? {
        val assignment = assignmentFor(place, request) ?: return null
        val plan = planOf(assignment, place, request)
        return GradingTask(assignment, plan).takeIf { plan.worlds.all { robotsAreFinished(it.world, console) } }
    }

    /** Grades [submissions], in their order. */
    fun grade(task: GradingTask, submissions: List<Submission>, request: GradeRequest): List<GradedHandIn> =
        runBlocking {
            val grader = HandInGrader(
                task.assignment,
                task.plan,
                loadPhysicsEngine(),
                console.language,
                request.options.java,
                request.options.milliseconds,
                request.options.firmware,
            )
            gradeAll(grader, submissions) { runs -> finish(runs, request.jobs) }
        }

    /** The assignment with the programs that the user gives to other robots; null if these cannot be used. */
    private fun assignmentFor(place: LoadedWorld, request: GradeRequest): Project? {
        val given = request.options.robots.groupBy({ it.robot }, { it.file }).map { (robot, names) ->
            val read = readProgramFiles(names, messages)
            val reason = when {
                read is ProgramFiles.Failure -> read.reason
                place.world.robots.none { it.name == robot } -> messages.noRobot(robot)
                robot == place.world.robots.first().name -> messages.firstRobotNamed(robot)
                else -> null
            }
            if (reason != null || read !is ProgramFiles.Success) {
                console.complain(reason.orEmpty())
                return null
            }
            read.notes.forEach(console::complain)
            val programs = read.programs.map { program ->
                ProjectProgram.of(program.source) ?: run {
                    console.complain(messages.compiled(program.path))
                    return null
                }
            }
            ProjectRobot(robot, programs)
        }
        val names = given.map { it.name }
        return place.project.copy(robots = place.project.robots.filter { it.name !in names } + given)
    }

    private fun planOf(assignment: Project, place: LoadedWorld, request: GradeRequest): GradingPlan {
        val plan = GradingPlan.of(assignment, request.seeds)
        val names = request.options.robotFiles.map { it.robot.ifEmpty { place.world.robots.first().name } }
        val built = place.world.robots.filter { it.name in names }.associate { it.name to it.description }
        val changes = WorldChanges(realism = request.options.realism, built = built)
        return plan.copy(worlds = plan.worlds.map { GradedWorld(it.name, changes.of(it.world)) })
    }

    private fun finish(runs: List<PreparedRun>, jobs: Int): List<RunResult> {
        val progress = GradeProgress.of(console, runs.size)
        val threads = Executors.newFixedThreadPool(jobs)
        try {
            val results = runs.map { run -> threads.submit<RunResult> { run.finish() } }
            return results.map { it.get().also { progress.runIsDone() } }
        } finally {
            threads.shutdownNow()
        }
    }
}
