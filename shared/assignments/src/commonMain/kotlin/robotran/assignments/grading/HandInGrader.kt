package robotran.assignments.grading

import robotran.assignments.collecting.Submission
import robotran.assignments.messages.GradingMessages
import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.programs.FirmwareSettings
import robotran.programs.JavaSettings
import robotran.programs.ProgramCompiler
import robotran.projects.PENBOT_TARGET
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.projects.RobotProgramSets
import robotran.projects.loadsWith
import robotran.projects.readRobotLoads
import robotran.projects.target
import robotran.projects.unfinishedRobot
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.grade.GoalRun
import robotran.simulation.physics.PhysicsEngine
import kotlin.coroutines.cancellation.CancellationException

/**
 * Grades hand-ins for [assignment] by [plan]. Compiling is not thread-safe; runs are independent of each other and may
 * take place at the same time.
 *
 * @param language of goals and errors.
 * @param java how Java programs run.
 * @param milliseconds of virtual time that a run takes at most; null for the time limit of its world.
 * @param firmware how programs for LEGO's own firmware are compiled.
 */
class HandInGrader(
    private val assignment: Project,
    val plan: GradingPlan,
    private val physics: PhysicsEngine,
    private val language: Language,
    java: JavaSettings = assignment.settings.java,
    private val milliseconds: Int? = null,
    firmware: FirmwareSettings = FirmwareSettings(),
) {
    private val compiler = ProgramCompiler(PENBOT_TARGET, java, language, firmware)

    /** Compiles the programs of [submission], and those of what may count in its place, for each world of the plan. */
    suspend fun prepare(submission: Submission.Usable): Preparation = try {
        val compiled = mutableMapOf<Any, RobotProgramSets>()
        val attempts = submission.attempts.map { prepareOne(it, compiled) }
        if (attempts.any { it is PreparedAttempt.Ready }) {
            Preparation.Ready(submission, attempts, this)
        } else {
            attempts.first().unready(submission.choose(0))
        }
    } catch (cancelled: CancellationException) {
        throw cancelled
    } catch (problem: Throwable) {
        Preparation.Failed(submission, listOf(reasonOf(problem)))
    }

    /** @param compiled what is known so far: variations mostly have the same robots, and compiling Java takes long. */
    private suspend fun prepareOne(
        submission: Submission.Usable,
        compiled: MutableMap<Any, RobotProgramSets>,
    ): PreparedAttempt {
        // That is no mistake of the pupil's.
        plan.worlds.firstNotNullOfOrNull { unfinishedRobot(it.world, language) }?.let { unfinished ->
            return PreparedAttempt.Failed(unfinished.diagnostics.map { it.message })
        }
        val loads = plan.worlds.map { graded ->
            when (val result = loadsFor(graded, submission.robot, compiled)) {
                is RobotProgramSets.Success -> result.loads
                is RobotProgramSets.Failure -> return PreparedAttempt.HasErrors(result.diagnostics.map(::lineOf))
            }
        }
        return PreparedAttempt.Ready(plan.worlds.zip(loads))
    }

    /** All programs of [robot] are on its brick, unless one that does not run has mistakes. */
    private suspend fun loadsFor(
        graded: GradedWorld,
        robot: ProjectRobot,
        compiled: MutableMap<Any, RobotProgramSets>,
    ): RobotProgramSets {
        val all = compiledFor(graded, robot, compiled)
        val first = robot.programs.getOrNull(robot.firstProgram)
        if (all is RobotProgramSets.Success || first == null || robot.programs.size == 1) return all
        return compiledFor(graded, robot.copy(programs = listOf(first), firstProgram = 0), compiled)
    }

    private suspend fun compiledFor(
        graded: GradedWorld,
        robot: ProjectRobot,
        compiled: MutableMap<Any, RobotProgramSets>,
    ): RobotProgramSets {
        val known = graded.world.robots.map { it.name }
        val own = graded.world.robots.first().name
        val first = assignment.world.robots.first().name
        // What one run has written must not help another, so grading begins with empty flash memories.
        val robots = (listOf(robot.copy(name = own)) + assignment.robots.filter { it.name != first })
            .map { it.copy(files = emptyList()) }
        val sources = robots.associate { it.name to it.programs.map { program -> program.program } }
        val robotsOfWorld = graded.world.robots.map { Triple(it.name, it.program, it.description.target) }
        val result = compiled.getOrPut(robot.programs to robotsOfWorld) {
            readRobotLoads(graded.world, compiler, sources.filterKeys { it in known })
        }
        return if (result is RobotProgramSets.Success) {
            result.copy(loads = loadsWith(robots, graded.world, result.loads))
        } else {
            result
        }
    }

    internal fun run(world: GradedWorld, loads: List<RobotProgramSet>, seed: Int, keepsState: Boolean) = PreparedRun(
        world,
        seed,
        keepsState,
        { Session(world.world.copy(seed = seed), loads, physics, language) },
        { session -> if (milliseconds == null) GoalRun(session) else GoalRun(session, milliseconds) },
        ::reasonOf,
    )

    private fun reasonOf(problem: Throwable): String =
        GradingMessages.of(language).couldNotBeGraded(problem.message ?: problem.toString())

    private fun lineOf(diagnostic: Diagnostic): String {
        val place = diagnostic.range?.let { ":${it.line}:${it.column}" }.orEmpty()
        return if (diagnostic.file.isEmpty()) diagnostic.message else "${diagnostic.file}$place: ${diagnostic.message}"
    }
}
