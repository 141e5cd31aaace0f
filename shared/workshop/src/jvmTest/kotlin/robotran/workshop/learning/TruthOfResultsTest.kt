package robotran.workshop.learning

import kotlinx.coroutines.runBlocking
import robotran.learning.Lessons
import robotran.learning.WorldGallery
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.ProgramShortfall
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.state.Notice
import robotran.workshop.state.WorkshopStatus
import robotran.world.Goal
import robotran.world.GoalCondition
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** What a run has done is told as it is: not before it is certain, and no longer than it is so. */
class TruthOfResultsTest {
    private val workshop = runBlocking { openWorkshop(platform = MemoryPlatform()) }
    private val learning get() = workshop.state.learning
    private val help get() = assertNotNull(learning.tutorial).help

    @AfterTest
    fun close() = workshop.close()

    private fun begin(lesson: String) =
        workshop.handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == lesson }))

    private fun runs(program: String) {
        workshop.handle(ProgramEvent.ProgramEdited(program))
        workshop.handle(RunEvent.RunPressed)
    }

    /** Runs it to the end in small steps, as on a screen; returns whether the lesson counted as done meanwhile. */
    private fun wasDoneMeanwhile(program: String): Boolean {
        runs(program)
        var wasDone = false
        repeat(STEPS) {
            workshop.advance(STEP)
            wasDone = wasDone || learning.isStepDone || learning.solved != null
        }
        return wasDone
    }

    @Test
    fun `a program that passes through the right place and number is never done, and gets a hint when time is up`() {
        begin("stripes")
        val solution = assertNotNull(learning.tutorial).current.solution.text
        assertEquals(false, wasDoneMeanwhile(solution.replace("repeat 4", "repeat 6")))
        assertEquals(WorkshopStatus.TimeUp(20), workshop.state.status)
        assertEquals("wrong number", help.fittingHint?.condition?.phrase)
        assertEquals(false, wasDoneMeanwhile(solution))
        workshop.handle(LearningEvent.OtherPlaceTried)
        repeat(STEPS) { workshop.advance(STEP) }
        assertTrue(learning.isStepDone)
    }

    @Test
    fun `a dice that beeps ten times is not done, whatever it shows`() {
        begin("dice")
        val tenBeeps = "show random(1, 12)\nrepeat 10 times\n  beep\n  wait 0.5 seconds\nend\n"
        assertEquals(false, wasDoneMeanwhile(tenBeeps))
        val described = workshop.state.run.shortfalls.map { it.shortfall }
        assertEquals(1, described.size, "one of the numbers is enough, so the nearest alone is told: $described")
        assertIs<ProgramShortfall.TooManyTones>(described.single())
        assertTrue(wasDoneMeanwhile(assertNotNull(learning.tutorial).current.solution.text))
    }

    @Test
    fun `a lesson that was done stays done, and a later try that fails is told as failed, with a hint`() {
        begin("first-drive")
        assertTrue(wasDoneMeanwhile("forward 30\nturn left 90\nforward 25\n"))
        assertNotNull(learning.solved)
        runs("forward 30\nturn left 90\nforward 40\n")
        repeat(STEPS) { workshop.advance(STEP) }
        assertNull(learning.solved)
        assertTrue(learning.isStepDone)
        assertEquals("too far", help.fittingHint?.condition?.phrase)
        assertTrue(workshop.state.run.shortfalls.isNotEmpty())
    }

    @Test
    fun `a run that goes on after the task is completed changes nothing`() {
        begin("bumping-along")
        runs(assertNotNull(learning.tutorial).current.solution.text)
        repeat(STEPS) { workshop.advance(STEP) }
        workshop.handle(LearningEvent.OtherPlaceTried)
        repeat(STEPS) { workshop.advance(STEP) }
        assertEquals(WorkshopStatus.Solved, workshop.state.status)
        val record = learning.solved
        workshop.handle(RunEvent.PausePressed)
        repeat(STEPS) { workshop.advance(STEP) }
        assertIs<WorkshopStatus.Running>(workshop.state.status)
        assertTrue(workshop.state.session.goals.all { it.status == GoalStatus.MET })
        assertEquals(record, learning.solved)
    }

    @Test
    fun `that all goals are met is told until the next run, and until the goals are others`() {
        val square = assertNotNull(WorldGallery.named("square"))
        val solution = assertNotNull(square.lesson).solution.text
        workshop.handle(LearningEvent.WorldChosen("square"))

        fun solve() {
            runs(solution)
            workshop.advance(30_000)
            assertIs<Notice.WorldSolved>(workshop.state.notice)
        }
        solve()
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(STEP)
        assertNull(workshop.state.notice)
        workshop.handle(LearningEvent.WorldChosen(square.harder.first().name))
        runs(assertNotNull(square.harder.first().lesson).solution.text)
        workshop.advance(30_000)
        assertIs<Notice.WorldSolved>(workshop.state.notice)
        val other = Goal(GoalCondition.EndWithin(10))
        workshop.services.editor.changeWorld(
            workshop.state.world.copy(goals = workshop.state.world.goals + other),
            false,
        )
        assertNull(workshop.state.notice)
    }

    @Test
    fun `a robot that has left the paper is told at once, and where it is`() {
        begin("pen")
        runs("forward 300\n")
        while (workshop.state.status !is WorkshopStatus.OffPaper && workshop.state.session.milliseconds < 20_000) {
            workshop.advance(STEP)
        }
        assertEquals(WorkshopStatus.OffPaper(robot = null), workshop.state.status)
        val paper = workshop.state.world.paper
        val stray = workshop.state.run.strayed.single()
        assertEquals(paper.width, stray.edge.x)
        assertTrue(stray.place.x - paper.width in 0.0..20.0, "${stray.place}")
    }

    private companion object {
        const val STEP = 100

        /** Longer than the time limits of these lessons. */
        const val STEPS = 250
    }
}
