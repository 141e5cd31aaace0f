package robotran.assignments.grading

import robotran.assignments.collecting.Submission
import robotran.assignments.messages.GradingMessages
import robotran.language.Language
import robotran.programs.FirmwareSettings
import robotran.programs.JavaSettings
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramDiagnostic
import robotran.projects.PENBOT_TARGET
import robotran.projects.Project
import robotran.projects.RobotLoads
import robotran.projects.loadsWith
import robotran.projects.readRobotLoads
import robotran.projects.target
import robotran.projects.unfinishedRobot
import robotran.simulation.RobotLoad
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

    /** Compiles the programs of [submission] for each world of the plan. */
    suspend fun prepare(submission: Submission.Usable): Preparation = try {
        prepareUnguarded(submission)
    } catch (cancelled: CancellationException) {
        throw cancelled
    } catch (problem: Throwable) {
        Preparation.Failed(submission, listOf(reasonOf(problem)))
    }

    private suspend fun prepareUnguarded(submission: Submission.Usable): Preparation {
        // That is no mistake of the pupil's.
        plan.worlds.firstNotNullOfOrNull { unfinishedRobot(it.world, language) }?.let { unfinished ->
            return Preparation.Failed(submission, unfinished.diagnostics.map { it.message })
        }
        val first = assignment.world.robots.first().name
        val robots = listOf(submission.robot.copy(name = first)) + assignment.robots.filter { it.name != first }
        val sources = robots.associate { robot -> robot.name to robot.programs.map { it.source } }
        // Variations mostly have the same robots, and compiling Java takes long.
        val compiled = mutableMapOf<Any, RobotLoads>()
        val loads = plan.worlds.map { graded ->
            val known = graded.world.robots.map { it.name }
            val own = graded.world.robots.first().name
            val given = sources.mapKeys { (name, _) -> if (name == first) own else name }.filterKeys { it in known }
            val robotsOfWorld = graded.world.robots.map { Triple(it.name, it.program, it.description.target) }
            val result = compiled.getOrPut(robotsOfWorld) { readRobotLoads(graded.world, compiler, given) }
            when (result) {
                is RobotLoads.Ready -> {
                    loadsWith(
                        robots.map { if (it.name == first) it.copy(name = own) else it },
                        graded.world,
                        result.loads,
                    )
                }

                is RobotLoads.HasErrors -> {
                    return Preparation.HasMistakes(submission, result.diagnostics.map(::lineOf))
                }
            }
        }
        return Preparation.Ready(submission, plan.worlds.zip(loads), this)
    }

    internal fun run(world: GradedWorld, loads: List<RobotLoad>, seed: Int, keepsState: Boolean) = PreparedRun(
        world,
        seed,
        keepsState,
        { Session(world.world.copy(seed = seed), loads, physics, language) },
        { session -> if (milliseconds == null) GoalRun(session) else GoalRun(session, milliseconds) },
        ::reasonOf,
    )

    private fun reasonOf(problem: Throwable): String =
        GradingMessages.of(language).couldNotBeGraded(problem.message ?: problem.toString())

    private fun lineOf(diagnostic: ProgramDiagnostic): String {
        val place = diagnostic.range?.let { ":${it.line}:${it.column}" }.orEmpty()
        return if (diagnostic.file.isEmpty()) diagnostic.message else "${diagnostic.file}$place: ${diagnostic.message}"
    }
}
