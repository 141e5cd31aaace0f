package robotran.assignments.grading

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.assignments.DRAWS
import robotran.assignments.collect
import robotran.assignments.collecting.Submission
import robotran.assignments.file
import robotran.language.Language
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.FingerTouchPart
import robotran.world.ReadyRobots
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class GradingSessionTest {
    private suspend fun grader() =
        HandInGrader(ASSIGNMENT, GradingPlan.of(ASSIGNMENT), loadPhysicsEngine(), Language.ENGLISH)

    private suspend fun submissions() = collect(
        file("anna.robo", DRAWS),
        file("ben.robo", "pen down\nforward 2\n"),
        file("cem.robo", "forwrd 2\n"),
        file("dora.pdf", ""),
        file("endless.robo", "repeat forever\n  var a = 1\nend\n"),
        file("Java.java", "class Java { public static void main(String[] a) { int[] b = null; b[0] = 1; } }"),
    )

    /** What a table shows. */
    private fun verdicts(results: List<GradedHandIn>) = results.map { result ->
        when (result) {
            is GradedHandIn.Graded -> "${result.submission.name} ${result.runs.map {
                it.world.name to it.grade.passed
            }}"

            is GradedHandIn.HasErrors -> "${result.submission.name} ${result.reasons}"
            is GradedHandIn.Failed -> "${result.submission.name} failed"
            is GradedHandIn.Unusable -> "${result.submission.name} unusable"
        }
    }

    @Test
    fun `slices give the same results as all at once`() = runTest {
        val session = GradingSession(grader(), submissions())
        var steps = 0
        while (!session.state.isOver) {
            session.step(700)
            steps++
        }
        assertTrue(steps > 20, "$steps")
        val whole = gradeAll(grader(), submissions()) { runs -> runs.map { it.finish() } }
        assertEquals(verdicts(whole), verdicts(session.state.results))
        val grades = { results: List<GradedHandIn> ->
            results.filterIsInstance<GradedHandIn.Graded>().flatMap { it.runs }.map { it.grade }
        }
        assertEquals(grades(whole), grades(session.state.results))
        assertEquals(16, session.state.runsDone)
        assertEquals(16, session.state.runsInTotal)
        assertIs<GradedHandIn.HasErrors>(whole[2])
        assertEquals(listOf(4, 0, 0, 0), whole.filterIsInstance<GradedHandIn.Graded>().map { it.met })
    }

    @Test
    fun `the rest takes as long as what is done`() = runTest {
        val session = GradingSession(grader(), submissions())
        assertNull(session.state.millisecondsLeft(100))
        assertEquals(20, session.state.runsInTotal)
        while (session.state.runsDone < 2) session.step(10_000)
        val row = assertIs<GradingRow.Running>(session.state.rows.first())
        assertEquals(2 to 4, row.done to row.total)
        assertEquals(900, session.state.millisecondsLeft(100))
    }

    @Test
    fun `cancelling leaves the rest waiting`() = runTest {
        val session = GradingSession(grader(), submissions())
        while (session.state.runsDone < 5) session.step(10_000)
        session.cancel()
        session.step(10_000)
        val state = session.state
        assertTrue(state.isOver && state.isCancelled)
        assertEquals(listOf("anna"), state.results.filterIsInstance<GradedHandIn.Graded>().map { it.submission.name })
        assertIs<GradingRow.Waiting>(state.rows[1])
    }

    @Test
    fun `a failure of Robotran itself costs one row`() = runTest {
        val submissions = submissions()
        val results = gradeAll(grader(), submissions) { runs ->
            runs.mapIndexed { index, run -> if (index == 5) RunResult.Failed("boom") else run.finish() }
        }
        assertEquals(listOf("boom"), assertIs<GradedHandIn.Failed>(results[1]).reasons)
        assertIs<GradedHandIn.Graded>(results[0])
        assertFalse(submissions.any { it is Submission.Unusable && it.name != "dora" })
    }

    @Test
    fun `as long as a robot is unfinished, no hand-in is graded, and none is blamed`() = runTest {
        val checks = assertNotNull(ASSIGNMENT.assignment?.checks)
        val draft = ReadyRobots.NXT_PENBOT.copy(title = "Two on one", parts = List(2) { FingerTouchPart(1) })
        val unfinished = checks.variations.map { variation ->
            val robots = variation.world.robots.map { it.copy(draft = draft) }
            variation.copy(world = variation.world.copy(robots = robots))
        }
        val assignment =
            ASSIGNMENT.copy(assignment = ASSIGNMENT.assignment?.copy(checks = checks.copy(variations = unfinished)))
        val grader = HandInGrader(assignment, GradingPlan.of(assignment), loadPhysicsEngine(), Language.ENGLISH)
        val results = gradeAll(grader, collect(file("anna.robo", DRAWS), file("cem.robo", "forwrd 2\n"))) { runs ->
            runs.map { it.finish() }
        }
        val reasons = results.flatMap { assertIs<GradedHandIn.Failed>(it).reasons }.toSet()
        assertTrue(
            reasons.single().startsWith("The robot yellow is not finished: \"Two on one\" cannot drive. "),
            "$reasons",
        )
    }
}
