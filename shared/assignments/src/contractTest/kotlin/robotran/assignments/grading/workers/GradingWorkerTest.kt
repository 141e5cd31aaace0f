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
import robotran.projects.Project
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.SessionState
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.World
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class GradingWorkerTest {
    private val plan = GradingPlan.of(ASSIGNMENT)

    /** The same task for a robot with an NXT. */
    private val nxtAssignment = ASSIGNMENT.withRobot(ReadyRobots.NXT_PENBOT)

    private fun World.withRobot(robot: RobotDescription) = copy(robots = robots.map { it.copy(description = robot) })

    private fun Project.withRobot(robot: RobotDescription): Project {
        val checks = assignment?.checks
        val variations = checks?.variations.orEmpty().map { it.copy(world = it.world.withRobot(robot)) }
        return copy(
            world = world.withRobot(robot),
            assignment = assignment?.copy(checks = checks?.copy(variations = variations)),
        )
    }

    private suspend fun worker(assignment: Project = ASSIGNMENT): GradingWorker {
        val order = assertNotNull(GradingOrder.of(assignment, GradingPlan.of(assignment), Language.GERMAN))
        return GradingWorker(GradingOrder.parse(order.write()), loadPhysicsEngine())
    }

    private suspend fun start(plan: GradingPlan = this.plan): SessionState =
        Session(plan.worlds.first().world, emptyList<RobotProgramSet>(), loadPhysicsEngine(), Language.ENGLISH).state

    private suspend fun submission(name: String, text: String) = collect(file(name, text)).single() as Submission.Usable

    @Test
    fun `results that went through texts are the same`() = runTest {
        val programs = listOf(DRAWS, "pen down\nforward 2\n", "repeat forever\n  turn left 90\nend\n", "beep\n")
        val described = compare(ASSIGNMENT, programs.map { submission("anna.robo", it) })
        assertTrue(described.containsAll(listOf(0, 1, 2, 3)), "$described")
    }

    @Test
    fun `those of robots with an NXT are, too`() = runTest {
        val head = "import lejos.nxt.*;\nclass Go {\n  public static void main(String[] a) {"
        val draws = "$head Motor.B.rotateTo(90); Motor.A.rotate(245, true); Motor.C.rotate(245); }\n}\n"
        val shows = "$head int[] none = null; LCD.drawInt(none[0], 0, 0); }\n}\n"
        compare(
            nxtAssignment,
            listOf(
                submission("anna.robo", DRAWS),
                submission("ben.robo", "repeat forever\n  show distance\n  turn left 45\nend\n"),
                submission("Go.java", draws),
                submission("Go.java", shows),
            ),
            met = listOf(4, 0, 4, 0),
        )
    }

    @Test
    fun `a program for the other brick has a mistake in a worker`() = runTest {
        val submission = submission("Go.java", "import josx.platform.rcx.*;\nclass Go { }\n")
        val nxtPlan = GradingPlan.of(nxtAssignment)
        val graded = readGraded(worker(nxtAssignment).grade(writeHandIn(submission)) {}, submission, nxtPlan, start())
        assertContains(assertIs<GradedHandIn.HasErrors>(graded).reasons.single(), "für einen RCX")
    }

    /**
     * Grades [submissions] here and in a worker.
     *
     * @param met how many runs of each meet all goals, if it matters.
     * @return the numbers of runs that were told.
     */
    private suspend fun compare(
        assignment: Project,
        submissions: List<Submission.Usable>,
        met: List<Int>? = null,
    ): List<Int> {
        val plan = GradingPlan.of(assignment)
        val worker = worker(assignment)
        val grader = HandInGrader(assignment, plan, loadPhysicsEngine(), Language.GERMAN)
        val described = mutableListOf<Int>()
        val passed = submissions.map { submission ->
            val here = assertIs<GradedHandIn.Graded>(grader.prepare(submission).finish {})
            val text = worker.grade(writeHandIn(submission), described::add)
            val there = assertIs<GradedHandIn.Graded>(readGraded(text, submission, plan, start(plan)))
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
            there.met
        }
        if (met != null) assertEquals(met, passed)
        return described
    }

    @Test
    fun `mistakes go through texts too`() = runTest {
        val submission = submission("cem.robo", "forwrd 2\n")
        val graded = readGraded(worker().grade(writeHandIn(submission)) {}, submission, plan, start())
        val grader = HandInGrader(ASSIGNMENT, plan, loadPhysicsEngine(), Language.GERMAN)
        assertEquals<GradedHandIn>(grader.prepare(submission).finish {}, graded)
        assertIs<GradedHandIn.HasErrors>(graded)
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
