package robotran.cli.grade

import robotran.language.Language
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.grade.Grade
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.PhysicsEngine
import robotran.world.World
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import java.util.concurrent.Future

/**
 * Runs programs in [world], each in its own session, several in parallel.
 *
 * @param milliseconds the max virtual time of a run.
 * @param jobs the number of parallel runs.
 * @param language the language of goals and errors.
 * @param onDone is called after each run, on the calling thread.
 */
internal class Grader(
    private val world: World,
    private val milliseconds: Int,
    private val physics: PhysicsEngine,
    private val jobs: Int,
    private val language: Language,
    private val onDone: () -> Unit,
) {
    /** Returns the grades for all [seeds], in order, for each of [loads]. */
    fun grade(loads: List<List<RobotProgramSet>>, seeds: IntRange): List<List<Grade>> {
        val threads = Executors.newFixedThreadPool(jobs)
        try {
            val runs = loads.map { load -> seeds.map { seed -> threads.submit<Grade> { grade(load, seed) } } }
            return runs.map { ofProgram -> ofProgram.map { run -> waitFor(run).also { onDone() } } }
        } finally {
            threads.shutdownNow()
        }
    }

    private fun grade(loads: List<RobotProgramSet>, seed: Int): Grade {
        val session = Session(world.copy(seed = seed), loads, physics, language)
        try {
            return session.runForGoals(milliseconds)
        } finally {
            session.close()
        }
    }

    private fun waitFor(run: Future<Grade>): Grade = try {
        run.get()
    } catch (problem: ExecutionException) {
        throw problem.cause ?: problem
    }
}
