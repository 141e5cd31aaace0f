package robotran.workshop.platform

import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.async
import kotlinx.coroutines.awaitAll
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import robotran.assignments.collecting.CollectedFile
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.collectHandIns
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.HandInGrader
import robotran.assignments.grading.finish
import robotran.language.Language
import robotran.simulation.physics.loadPhysicsEngine
import robotran.workshop.handins.AnyClass
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertTrue

class GradingThreadsTest {
    private val assignment = AnyClass.teachers
    private val plan = GradingPlan.of(assignment)

    private suspend fun submissions() = collectHandIns(
        AnyClass.few.map {
            CollectedFile(it.path, it.bytes)
        },
        assignment,
        language = Language.ENGLISH,
    ).submissions.filterIsInstance<Submission.Usable>()

    private fun reports(graded: GradedHandIn) = (graded as? GradedHandIn.Graded)?.runs?.map { it.grade }

    @Test
    fun `several threads find out the same as one`() = runBlocking {
        val grader = HandInGrader(assignment, plan, loadPhysicsEngine(), Language.ENGLISH)
        val alone = submissions().map { grader.prepare(it).finish {} }
        val crew = GradingThreads(3).start(assignment, plan, Language.ENGLISH)
        val described = mutableListOf<Int>()
        val caller = Thread.currentThread()
        val together = coroutineScope {
            submissions().map { submission ->
                async {
                    crew.grade(submission) { runs ->
                        assertEquals(caller, Thread.currentThread())
                        described += runs
                    }
                }
            }.awaitAll()
        }
        crew.close()
        assertEquals(alone.map(::reports), together.map(::reports))
        assertEquals(alone.map { it.submission }, together.map { it.submission })
        assertTrue(described.any { it > 0 }, "$described")
    }

    @Test
    fun `cancelling ends the work`() = runBlocking {
        val crew = GradingThreads(1).start(assignment, GradingPlan.of(assignment, 1..100_000), Language.ENGLISH)
        val work = launch {
            assertFailsWith<CancellationException> { crew.grade(submissions().first()) {} }
        }
        launch { work.cancelAndJoin() }.join()
        crew.close()
    }
}
