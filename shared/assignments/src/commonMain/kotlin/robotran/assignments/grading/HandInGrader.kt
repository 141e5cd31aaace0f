package robotran.assignments.grading

import robotran.assignments.collecting.Submission
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
import robotran.simulation.grade.GoalRun
import robotran.simulation.grade.Grade
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.state.SessionState
import robotran.world.World

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
    private val compiler = ProgramCompiler(PENBOT_CALIBRATION, language = language)

    /** Compiles the programs of [submission] for each world of the plan. */
    suspend fun prepare(submission: Submission.Usable): Preparation {
        val first = assignment.world.robots.first().name
        val robots = listOf(submission.robot.copy(name = first)) + assignment.robots.filter { it.name != first }
        val sources = robots.associate { robot -> robot.name to robot.programs.map { it.source } }
        val loads = plan.worlds.map { graded ->
            val known = graded.world.robots.map { it.name }
            val own = graded.world.robots.first().name
            val given = sources.mapKeys { (name, _) -> if (name == first) own else name }.filterKeys { it in known }
            when (val result = readRobotLoads(graded.world, compiler, given)) {
                is RobotLoads.Ready -> loadsWith(
                    robots.map { if (it.name == first) it.copy(name = own) else it },
                    graded.world,
                    result.loads,
                )

                is RobotLoads.HasErrors -> return Preparation.HasMistakes(result.diagnostics.map(::lineOf))
            }
        }
        return Preparation.Ready(submission, plan.worlds.zip(loads), this)
    }

    internal fun session(world: World, loads: List<RobotLoad>, seed: Int) =
        Session(world.copy(seed = seed), loads, physics, language)

    private fun lineOf(diagnostic: ProgramDiagnostic): String {
        val place = diagnostic.range?.let { ":${it.line}:${it.column}" }.orEmpty()
        return if (diagnostic.file.isEmpty()) diagnostic.message else "${diagnostic.file}$place: ${diagnostic.message}"
    }
}

/** The result of compiling a hand-in. */
sealed interface Preparation {
    /** It can run. */
    class Ready internal constructor(
        val submission: Submission.Usable,
        private val worlds: List<Pair<GradedWorld, List<RobotLoad>>>,
        private val grader: HandInGrader,
    ) : Preparation {
        /** All its runs, in the order of the plan. None has begun. */
        fun runs(): List<PreparedRun> = worlds.flatMap { (graded, loads) ->
            grader.plan.seeds.map { seed -> PreparedRun(graded, seed) { grader.session(graded.world, loads, seed) } }
        }
    }

    /** Each of [reasons] is a line of text. */
    data class HasMistakes(val reasons: List<String>) : Preparation
}

/** A run of grading, which begins with the first [advance]. */
class PreparedRun internal constructor(val world: GradedWorld, val seed: Int, private val begin: () -> Session) {
    private var session: Session? = null
    private var run: GoalRun? = null

    /** Runs for at most [milliseconds] of virtual time; returns the result once the run is over. */
    fun advance(milliseconds: Int): RunResult? {
        val session = session ?: begin().also { session = it }
        val run = run ?: GoalRun(session).also { run = it }
        run.advance(milliseconds)
        return if (run.isOver) RunResult(run.grade(), session.state).also { close() } else null
    }

    /** Ends the run without a result; does nothing if it is over. */
    fun close() {
        session?.close()
        session = null
        run = null
    }
}

/** @property state the end of the run. */
class RunResult(val grade: Grade, val state: SessionState)
