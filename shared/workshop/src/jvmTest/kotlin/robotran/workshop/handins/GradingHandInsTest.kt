package robotran.workshop.handins

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.test.advanceUntilIdle
import kotlinx.coroutines.test.runCurrent
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.language.Language
import robotran.programs.ProgramCompiler
import robotran.projects.PENBOT_TARGET
import robotran.projects.Project
import robotran.projects.RobotProgramSets
import robotran.projects.readRobotLoads
import robotran.simulation.Session
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.loadPhysicsEngine
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.event.HandInsEvent
import robotran.workshop.platform.GradingCrew
import robotran.workshop.platform.GradingThreads
import robotran.workshop.platform.GradingWorkers
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInVerdict
import robotran.workshop.state.HandInsKind
import robotran.workshop.state.HandInsMessage
import robotran.world.World
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Tests the grades of hand-ins, and when they come. */
@OptIn(ExperimentalCoroutinesApi::class)
internal class GradingHandInsTest : HandInsTesting() {
    @Test
    fun `every hand-in has its verdict, and hostile ones cost only their row`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        val expected = mapOf(
            "Ada" to HandInVerdict.PASSED,
            "Ben" to HandInVerdict.MISSED,
            "Cleo" to HandInVerdict.PARTLY,
            "Dina" to HandInVerdict.HAS_MISTAKES,
            "Emil" to HandInVerdict.MISSED,
            "Fritz" to HandInVerdict.UNUSABLE,
        )
        assertEquals(expected, workshop.page.rows.associate { it.name to it.verdict })
        assertNull(workshop.page.progress)
        assertEquals(HandInsMessage.Brought(5, 0, unusable = 1), workshop.page.message)
        val ada = workshop.row("Ada")
        assertEquals(listOf(2, 2), listOf(ada.lines, (ada.submission as Submission.Usable).handIn?.tries))
    }

    @Test
    fun `the grades are those of runForGoals`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        for (name in listOf("Ada", "Ben", "Cleo")) {
            val graded = checkNotNull(workshop.row(name).results)
            assertEquals(20, graded.runs.size)
            for (run in graded.runs) {
                assertEquals(
                    gradeAlone(workshop.row(name), run.world.world.copy(seed = run.grade.seed)),
                    run.grade.report.toJson(),
                )
            }
        }
    }

    @Test
    fun `without checks a hand-in runs once, and the page says why`() =
        looking(AnyClass.teachers.withoutChecks()) { workshop ->
            assertEquals(HandInsKind.WITHOUT_CHECKS, workshop.page.kind)
            workshop.bring(AnyClass.few.take(2))
            assertEquals(listOf(1, 1), workshop.page.rows.map { it.results?.runs?.size })
        }

    @Test
    fun `a world without goals offers no page, and any world with goals does`() = looking(null) { workshop ->
        assertFalse(workshop.state.document.hasGoals)
        workshop.services.editor.changeWorld(AnyAssignment.world)
        assertTrue(workshop.state.document.hasGoals)
        workshop.handle(HandInsEvent.Requested)
        advanceUntilIdle()
        assertEquals(HandInsKind.WORLD, workshop.page.kind)
        workshop.bring(AnyClass.few.take(1))
        assertEquals(listOf(HandInVerdict.PASSED), workshop.page.rows.map { it.verdict })
    }

    @Test
    fun `grading goes on in slices, can be stopped, and goes on again`() = looking { workshop ->
        files.chosen = AnyClass.few
        workshop.handle(HandInsEvent.FilesRequested)
        runCurrent()
        while (workshop.page.rows.none { it.name == "Ada" && it.graded != null }) {
            testScheduler.advanceTimeBy(1)
            runCurrent()
        }
        val progress = assertNotNull(workshop.page.progress)
        assertEquals(listOf(2, 6), listOf(progress.handIns, progress.of))
        assertTrue(progress.part in 0.1f..0.9f, "$progress")
        assertTrue(progress.secondsLeft in 1..1_000, "$progress")
        workshop.handle(HandInsEvent.GradingCancelled)
        advanceUntilIdle()
        assertNull(workshop.page.progress)
        assertTrue(workshop.page.isStopped)
        val waiting = workshop.page.rows.filter { it.verdict == HandInVerdict.WAITING }.map { it.name }
        assertEquals(listOf("Ben", "Cleo", "Dina", "Emil"), waiting.sorted())
        workshop.handle(HandInsEvent.GradingResumed)
        advanceUntilIdle()
        assertFalse(workshop.page.isStopped)
        assertTrue(workshop.page.rows.none { it.graded == null })
    }

    @Test
    fun `workers of the platform grade the same`() {
        workers = GradingThreads(2)
        looking { workshop ->
            workshop.bring(AnyClass.few)
            while (workshop.page.progress != null) {
                Thread.sleep(5)
                advanceUntilIdle()
            }
            val graded = workshop.page.rows.associate { it.name to it.verdict }
            assertEquals(HandInVerdict.PASSED, graded["Ada"])
            assertEquals(HandInVerdict.PARTLY, graded["Cleo"])
            assertEquals(HandInVerdict.HAS_MISTAKES, graded["Dina"])
        }
    }

    @Test
    fun `what comes while others are graded does not disturb them`() {
        val begun = mutableListOf<String>()
        val next = Channel<Unit>(Channel.UNLIMITED)
        workers = workersOf { submission ->
            begun += submission.name
            next.receive()
            GradedHandIn.HasErrors(submission, emptyList())
        }
        looking { workshop ->
            workshop.bring(AnyClass.few.take(2))
            val first = begun.toList()
            workshop.bring(listOf(AnyClass.file("Gabi", AnyClass.solved)))
            workshop.handle(HandInsEvent.HandInRemoved("Gabi"))
            workshop.handle(HandInsEvent.RemovalUndone)
            advanceUntilIdle()
            assertEquals(first, begun)
            assertEquals(listOf(0, 3), workshop.page.progress?.run { listOf(handIns, of) })
            repeat(3) { next.trySend(Unit) }
            advanceUntilIdle()
            assertEquals(listOf("Ada", "Ben", "Gabi"), begun)
            assertTrue(workshop.page.rows.none { it.graded == null })
            assertNull(workshop.page.progress)
        }
    }

    @Test
    fun `a hand-in that is replaced while it is graded has the grade of the new one`() {
        val next = Channel<Unit>(Channel.UNLIMITED)
        workers = workersOf { submission ->
            next.receive()
            GradedHandIn.HasErrors(submission, listOf("${submission.handIn?.tries}"))
        }
        looking { workshop ->
            workshop.bring(listOf(AnyClass.file("Ada", AnyClass.short, tries = 1)))
            workshop.bring(listOf(AnyClass.file("Ada", AnyClass.solved, tries = 4)))
            repeat(2) { next.trySend(Unit) }
            advanceUntilIdle()
            val graded = workshop.page.rows.single().graded as GradedHandIn.HasErrors
            assertEquals(listOf("4"), graded.reasons)
        }
    }

    /** Workers that grade with [result]. */
    private fun workersOf(result: suspend (Submission.Usable) -> GradedHandIn) = object : GradingWorkers {
        override suspend fun start(assignment: Project, plan: GradingPlan, language: Language) = object : GradingCrew {
            override val size = 1

            override suspend fun grade(submission: Submission.Usable, onProgress: (runs: Int) -> Unit): GradedHandIn =
                result(submission)

            override fun close() = Unit
        }
    }

    private suspend fun gradeAlone(row: HandInRow, world: World): String {
        val robot = world.robots.first().name
        val loads =
            readRobotLoads(
                world,
                ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH),
                mapOf(
                    robot to row.programs.map {
                        it.program
                    },
                ),
            )
        val session =
            Session(world, assertIs<RobotProgramSets.Success>(loads).loads, loadPhysicsEngine(), Language.ENGLISH)
        return session.runForGoals().report.toJson().also { session.close() }
    }

    private fun Project.withoutChecks() = copy(assignment = assignment?.copy(checks = null))
}
