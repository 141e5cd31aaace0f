package robotran.assignments.grading

import robotran.assignments.collecting.Submission
import robotran.assignments.messages.GradingMessages
import robotran.language.Language
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramDiagnostic
import robotran.projects.PENBOT_CALIBRATION
import robotran.projects.Project
import robotran.projects.RobotLoads
import robotran.projects.loadsWith
import robotran.projects.readRobotLoads
import robotran.simulation.RobotLoad
import robotran.simulation.Session
import robotran.simulation.physics.PhysicsEngine
import robotran.world.World
import kotlin.coroutines.cancellation.CancellationException

/**
 * Grades hand-ins for [assignment] by [plan]. Compiling is not thread-safe; runs are independent of each other and may
 * take place at the same time.
 *
 * @param language of goals and errors.
 */
class HandInGrader(
    private val assignment: Project,
    val plan: GradingPlan,
    private val physics: PhysicsEngine,
    private val language: Language,
) {
    private val compiler = ProgramCompiler(PENBOT_CALIBRATION, assignment.settings.java, language)

    /** Compiles the programs of [submission] for each world of the plan. */
    suspend fun prepare(submission: Submission.Usable): Preparation = try {
        prepareUnguarded(submission)
    } catch (cancelled: CancellationException) {
        throw cancelled
    } catch (problem: Throwable) {
        Preparation.Failed(submission, listOf(reasonOf(problem)))
    }

    private suspend fun prepareUnguarded(submission: Submission.Usable): Preparation {
        val first = assignment.world.robots.first().name
        val robots = listOf(submission.robot.copy(name = first)) + assignment.robots.filter { it.name != first }
        val sources = robots.associate { robot -> robot.name to robot.programs.map { it.source } }
        // Variations mostly have the same robots, and compiling Java takes long.
        val compiled = mutableMapOf<Any, RobotLoads>()
        val loads = plan.worlds.map { graded ->
            val known = graded.world.robots.map { it.name }
            val own = graded.world.robots.first().name
            val given = sources.mapKeys { (name, _) -> if (name == first) own else name }.filterKeys { it in known }
            val robotsOfWorld = graded.world.robots.map { it.name to it.program }
            val result = compiled.getOrPut(robotsOfWorld) { readRobotLoads(graded.world, compiler, given) }
            when (result) {
                is RobotLoads.Ready -> loadsWith(
                    robots.map { if (it.name == first) it.copy(name = own) else it },
                    graded.world,
                    result.loads,
                )

                is RobotLoads.HasErrors ->
                    return Preparation.HasMistakes(submission, result.diagnostics.map(::lineOf))
            }
        }
        return Preparation.Ready(submission, plan.worlds.zip(loads), this)
    }

    internal fun session(world: World, loads: List<RobotLoad>, seed: Int) =
        Session(world.copy(seed = seed), loads, physics, language)

    internal fun reasonOf(problem: Throwable): String =
        GradingMessages.of(language).couldNotBeGraded(problem.message ?: problem.toString())

    private fun lineOf(diagnostic: ProgramDiagnostic): String {
        val place = diagnostic.range?.let { ":${it.line}:${it.column}" }.orEmpty()
        return if (diagnostic.file.isEmpty()) diagnostic.message else "${diagnostic.file}$place: ${diagnostic.message}"
    }
}
