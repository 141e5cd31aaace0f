package robotran.assignments.grading

import kotlinx.coroutines.test.runTest
import robotran.assignments.collecting.CollectedFile
import robotran.assignments.collecting.collectHandIns
import robotran.assignments.comparing.compareSubmissions
import robotran.assignments.reporting.ClassReport
import robotran.assignments.reporting.csvFile
import robotran.language.Language
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.simulation.physics.loadPhysicsEngine
import java.io.File
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull

/** The browser tests hold the page against the same records, `grades.csv`; `record-grades.sh` writes them anew. */
class RecordedGradesTest {
    @Test
    fun `a class with hostile hand-ins gets the recorded grades`() = check("/grades", "parking.robotran")

    @Test
    fun `so does a class with robots that have an NXT`() = check("/grades/nxt", "wall.robotran")

    private fun check(resource: String, assignmentFile: String) = runTest {
        val folder = File(assertNotNull(javaClass.getResource(resource)).toURI())
        val assignment = assertIs<ProjectFileResult.Success>(
            readProject(folder.resolve(assignmentFile).readText(), Language.ENGLISH),
        ).project
        val files = folder.resolve("class").listFiles().orEmpty().sorted().map {
            CollectedFile(it.name, it.readBytes())
        }
        val plan = GradingPlan.of(assignment)
        val grader = HandInGrader(assignment, plan, loadPhysicsEngine(), Language.ENGLISH)
        val submissions = collectHandIns(files, assignment, Language.ENGLISH).submissions
        val results = gradeAll(grader, submissions) { runs -> runs.map { it.finish() } }
        assertEquals(
            folder.resolve("grades.csv").readText(),
            csvFile(
                ClassReport(assignment, plan, results, compareSubmissions(submissions, assignment)),
                language = Language.ENGLISH,
            ).decodeToString(),
        )
    }
}
