package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.programs.ProgramCompiler
import robotran.robolang.robot.RobotTarget
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.report
import robotran.world.Penbot
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.time.Duration.Companion.minutes

/**
 * Runs ten worlds with many objects - 40 barriers, 10 blocks, marks, lamps, three robots that draw, noise - and
 * recorded inputs, and compares the reports with those in `resources/runs`. Their trace hash covers all poses after
 * each step and every ROM call. The tests of the command line and the web page use the same records; `record-runs.sh`
 * updates them.
 */
class ProjectRunTest {
    private val projects = recordedProjects.filterKeys { it.endsWith(".robotran") }

    @Test
    fun `ten projects full of things make their recorded runs`() = runTest(timeout = 10.minutes) {
        assertEquals(10, projects.size)
        for ((name, text) in projects) {
            val project = assertIs<ProjectFileResult.Success>(readProject(text, Language.ENGLISH)).project
            val reader =
                ProgramCompiler(
                    RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE),
                    project.settings.java,
                    language = Language.ENGLISH,
                )
            val loads = assertIs<RobotProgramSets.Success>(readRobotLoads(project, reader)).loads
            val session = Session.replay(
                project.worldToRun,
                loads,
                loadPhysicsEngine(),
                project.inputs,
                MILLISECONDS,
                Language.ENGLISH,
            )
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
