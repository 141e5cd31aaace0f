package robotran.assignments.course.thorough

import kotlinx.coroutines.test.runTest
import robotran.assignments.collecting.Submission
import robotran.assignments.course.OwnCourses
import robotran.assignments.course.assignmentId
import robotran.assignments.doing.firstPrograms
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.HandInGrader
import robotran.assignments.grading.Preparation
import robotran.language.Language
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.simulation.physics.loadPhysicsEngine
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.minutes

/** The tests of lessons and worlds try all 20 seeds; these try that grading finds the same. */
class OwnCoursesGradedTest {
    @Test
    fun `every solution passes, and the program to begin with does not`() = runTest(timeout = 10.minutes) {
        val wrong = OwnCourses.names.flatMap {
            OwnCourses.named(it, Language.ENGLISH)?.assignments.orEmpty()
        }.filterNot {
            passes(it, it.assignment?.solution.orEmpty(), 1..2) && !passes(it, it.firstPrograms, 1..1)
        }
        assertEquals(emptyList(), wrong.map { it.assignmentId })
    }

    private suspend fun passes(project: Project, programs: List<ProjectProgram>, seeds: IntRange): Boolean {
        val grader = HandInGrader(project, GradingPlan.of(project, seeds), loadPhysicsEngine(), Language.ENGLISH)
        val robot = ProjectRobot(project.world.robots.first().name, programs)
        val ready = when (val made = grader.prepare(Submission.Usable("", "", robot))) {
            is Preparation.Ready -> made
            is Preparation.HasErrors -> return false
            is Preparation.Failed -> throw AssertionError("${project.assignmentId}: ${made.reasons}")
        }
        val graded = ready.graded(ready.runs().map { it.finish() })
        return (graded as GradedHandIn.Graded).hasPassed
    }
}
