package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.programs.ProgramCompiler
import robotran.robolang.robot.Calibration
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.report
import robotran.world.Penbot
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.time.Duration.Companion.minutes

/**
 * Ten worlds full of things - 40 barriers, 10 blocks, marks, lamps, three robots that draw, noise - and what was done
 * in them from outside leave the reports recorded in `resources/runs`, whose trace hash counts where everything is
 * after each step and every ROM call: on every target, on the command line and in the page in a browser, which are held
 * against the same records. `record-runs.sh` makes them anew.
 */
class ProjectRunTest {
    private val projects = recordedProjects.filterKeys { it.endsWith(".robotran") }

    @Test
    fun `ten projects full of things make their recorded runs`() = runTest(timeout = 10.minutes) {
        assertEquals(10, projects.size)
        for ((name, text) in projects) {
            val project = assertIs<ProjectFileResult.Loaded>(readProject(text)).project
            val reader =
                ProgramCompiler(
                    Calibration(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE),
                    project.settings.java,
                )
            val loads = assertIs<RobotLoads.Ready>(readRobotLoads(project, reader)).loads
            val session = Session.replay(project.worldToRun, loads, loadPhysicsEngine(), project.inputs, MILLISECONDS)
            session.finish()
            session.close()
            assertEquals(
                recordedProjects.getValue(name.replace(".robotran", ".report.json")),
                session.report().toJson() + "\n",
                name,
            )
        }
    }

    private companion object {
        const val MILLISECONDS = 60_000L
    }
}
