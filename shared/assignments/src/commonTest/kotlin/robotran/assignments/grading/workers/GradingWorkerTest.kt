package robotran.assignments.grading.workers

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.assignments.DRAWS
import robotran.assignments.collect
import robotran.assignments.collecting.Submission
import robotran.assignments.file
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.HandInGrader
import robotran.assignments.grading.finish
import robotran.language.Language
import robotran.simulation.RobotLoad
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.SessionState
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class GradingWorkerTest {
    private val plan = GradingPlan.of(ASSIGNMENT)

    private suspend fun worker(): GradingWorker {
        val order = assertNotNull(GradingOrder.of(ASSIGNMENT, plan, Language.GERMAN))
        return GradingWorker(GradingOrder.parse(order.write()), loadPhysicsEngine())
    }

    private suspend fun start(): SessionState =
        Session(plan.worlds.first().world, emptyList<RobotLoad>(), loadPhysicsEngine()).state

    private suspend fun submission(name: String, text: String) = collect(file(name, text)).single() as Submission.Usable

    @Test
    fun `results that went through texts are the same`() = runTest {
        val worker = worker()
        val grader = HandInGrader(ASSIGNMENT, plan, loadPhysicsEngine(), Language.GERMAN)
        val told = mutableListOf<Int>()
        for (program in listOf(DRAWS, "pen down\nforward 2\n", "repeat forever\n  turn left 90\nend\n", "beep\n")) {
            val submission = submission("anna.robo", program)
            val here = assertIs<GradedHandIn.Graded>(grader.prepare(submission).finish {})
            val text = worker.grade(writeHandIn(submission), told::add)
            val there = assertIs<GradedHandIn.Graded>(readGraded(text, submission, plan, start()))
            assertEquals(here.submission, there.submission)
            assertEquals(
                here.runs.map { listOf(it.world, it.grade.seed, it.grade.passed, it.grade.seconds, it.grade.report) },
                there.runs.map { listOf(it.world, it.grade.seed, it.grade.passed, it.grade.seconds, it.grade.report) },
            )
            assertEquals(
                here.runs.map {
                    it.grade.goals.map { goal ->
                        goal.copy(shortfall = null)
                    }
                },
                there.runs.map { it.grade.goals },
            )
            assertEquals(here.picture.ink.strokes.size, there.picture.ink.strokes.size)
            val poses = listOf(here, there).map { it.picture.robot.pose }
            assertEquals(poses[0].x, poses[1].x, 0.001)
            assertEquals(poses[0].heading, poses[1].heading, 0.001)
            assertEquals(here.picture.brick.motors.map { it.mode }, there.picture.brick.motors.map { it.mode })
            assertEquals(here.picture.goals.map { it.status }, there.picture.goals.map { it.status })
        }
        assertTrue(told.containsAll(listOf(0, 1, 2, 3)), "$told")
    }

    @Test
    fun `mistakes go through texts too`() = runTest {
        val submission = submission("cem.robo", "forwrd 2\n")
        val graded = readGraded(worker().grade(writeHandIn(submission)) {}, submission, plan, start())
        val grader = HandInGrader(ASSIGNMENT, plan, loadPhysicsEngine(), Language.GERMAN)
        assertEquals<GradedHandIn>(grader.prepare(submission).finish {}, graded)
        assertIs<GradedHandIn.HasMistakes>(graded)
    }

    @Test
    fun `texts of anything else are refused`() = runTest {
        val submission = submission("anna.robo", DRAWS)
        assertFailsWith<IllegalArgumentException> { worker().grade("{}") {} }
        assertFailsWith<IllegalArgumentException> { readGraded("{}", submission, plan, start()) }
        assertFailsWith<IllegalArgumentException> { GradingOrder.parse("hello") }
    }

    @Test
    fun `a plan that does not follow from the assignment cannot be written`() {
        assertNotNull(GradingOrder.of(ASSIGNMENT, GradingPlan.of(ASSIGNMENT, 5..9), Language.ENGLISH))
        val other = plan.copy(worlds = plan.worlds.take(1))
        assertNull(GradingOrder.of(ASSIGNMENT, other, Language.ENGLISH))
    }
}
