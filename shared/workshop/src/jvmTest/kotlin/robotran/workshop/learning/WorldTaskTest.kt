package robotran.workshop.learning

import kotlinx.coroutines.runBlocking
import robotran.blockediting.palette.Palette
import robotran.language.ProgramLanguage
import robotran.learning.HintStage
import robotran.learning.WorldGallery
import robotran.projects.ProgramView
import robotran.simulation.state.GoalStatus
import robotran.workshop.blocks.DragPayload
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.examples.EARLIER_FIRST_PROGRAMS
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.WorkshopStatus
import robotran.workshop.state.WorldTaskState
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class WorldTaskTest {
    private val workshop = runBlocking { openWorkshop(platform = MemoryPlatform()) }
    private val square = checkNotNull(WorldGallery.named("square"))
    private val task get() = checkNotNull(square.lesson)
    private val shown: WorldTaskState get() = assertNotNull(workshop.state.learning.worldTask)
    private val tabs get() = workshop.state.programs.programs.map { it.name }

    @AfterTest
    fun close() = workshop.close()

    private fun choose(name: String) = workshop.handle(LearningEvent.WorldChosen(name))

    private fun tries(program: String) {
        workshop.handle(ProgramEvent.ProgramEdited(program))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(30_000)
    }

    @Test
    fun `a world with a task offers a program to begin with, which takes the place of none`() {
        workshop.handle(ProgramEvent.ProgramEdited("forward 7\n"))
        choose("square")
        assertTrue(shown.canStart)
        assertEquals("forward 7\n", workshop.state.programText)
        workshop.handle(LearningEvent.WorldProgramRequested)
        assertEquals(task.program.text, workshop.state.programText)
        assertEquals(Pane.PROGRAM, workshop.state.pane)
        assertFalse(shown.canStart)
        assertEquals("forward 7\n", workshop.state.programs.programs.first().files.single().text)
        workshop.handle(ProgramEvent.ProgramEdited("forward 8\n"))
        workshop.handle(ProgramEvent.ProgramChosen(0))
        workshop.handle(LearningEvent.WorldProgramRequested)
        assertEquals("forward 8\n", workshop.state.programText)
        assertEquals(listOf("square.robo", task.program.name), tabs)
    }

    @Test
    fun `a first program of an earlier version that is unchanged makes way for the one to begin with`() {
        for (earlier in EARLIER_FIRST_PROGRAMS) {
            choose("plain")
            workshop.handle(ProgramEvent.ProgramEdited("$earlier\n"))
            choose("square")
            assertEquals(listOf(task.program.name), tabs)
            assertEquals(task.program.text, workshop.state.programText)
        }
    }

    @Test
    fun `the free sheet and the lessons have no such task`() {
        choose("plain")
        assertNull(workshop.state.learning.worldTask)
        choose("square")
        workshop.handle(LearningEvent.TutorialStarted)
        assertNull(workshop.state.learning.worldTask)
    }

    @Test
    fun `after a try that failed the hint that fits is there, and each touch shows one more`() {
        choose("square")
        tries(task.solution.text.replace("left", "right"))
        assertEquals(listOf("turned the wrong way"), shown.help.hints.map { it.condition?.phrase })
        repeat(2) { workshop.handle(LearningEvent.WorldHintRequested(true)) }
        assertEquals(HintStage.entries.drop(1), shown.help.hints.drop(1).map { it.stage })
        assertNull(shown.help.nextStage)
        workshop.handle(LearningEvent.WorldHintRequested(false))
        assertTrue(shown.help.hints.isEmpty())
        tries(task.solution.text)
        assertNull(shown.help.fittingHint)
    }

    @Test
    fun `the program to begin with has no hint of a try with another`() {
        choose("square")
        tries(task.solution.text.replace("left", "right"))
        assertEquals(1, shown.help.hints.size)
        workshop.handle(LearningEvent.WorldProgramRequested)
        assertTrue(shown.help.hints.isEmpty())
    }

    @Test
    fun `the program to begin with has a fresh sheet, and the pupil's own stays`() {
        choose("square")
        val start = workshop.state.session.robot.pose
        tries("pen down\nforward 10\n")
        assertTrue(workshop.state.session.ink.lengthCentimetres > 5)
        assertTrue(workshop.state.run.shortfalls.isNotEmpty())
        workshop.handle(LearningEvent.WorldProgramRequested)
        val now = workshop.state
        assertEquals(0.0, now.session.ink.lengthCentimetres)
        assertEquals(0, now.session.milliseconds)
        assertEquals(start, now.session.robot.pose)
        assertTrue(now.session.goals.all { it.status == GoalStatus.PENDING })
        assertEquals(emptyList(), now.run.shortfalls)
        assertEquals(WorkshopStatus.Ready, now.status)
        assertEquals("pen down\nforward 10\n", now.programs.programs.first().files.single().text)
    }

    @Test
    fun `whichever way a run begins, one line of the task stays, and it comes back whole`() {
        val brick = workshop.state.session.brick.kind.startButton
        val starts = listOf(
            listOf(RunEvent.RunPressed),
            listOf(RunEvent.ButtonPressed(brick)),
            listOf(
                BlockEvent.ViewChosen(ProgramView.BLOCKS),
                BlockEvent.SnippetRequested(
                    DragPayload.New(
                        Palette.blocks.first {
                            it.id == "move"
                        },
                    ),
                ),
            ),
        )
        for (start in starts) {
            choose("plain")
            choose("square")
            assertTrue(workshop.state.taskShown && !workshop.state.taskFolded)
            start.forEach(workshop::handle)
            workshop.advance(200)
            assertTrue(workshop.state.taskShown && workshop.state.taskFolded, "$start")
            workshop.handle(RunEvent.ButtonReleased(brick))
            workshop.handle(ScreenEvent.TaskShown(true))
            assertFalse(workshop.state.taskFolded)
        }
    }

    @Test
    fun `a try in another language gets the nudge`() {
        choose("square")
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        runBlocking { workshop.compilePrograms() }
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(60_000)
        assertEquals(task.text(workshop.language).nudge, shown.help.hints.single().text)
    }

    @Test
    fun `show me runs the solution in a tab of its own, solves nothing, and leaves with it`() {
        choose("square")
        workshop.handle(ProgramEvent.ProgramEdited("forward 1\n"))
        workshop.handle(LearningEvent.WorldSolutionRequested(true))
        assertEquals(task.solution.text, workshop.state.programText)
        assertTrue(shown.help.solutionShown)
        workshop.advance(30_000)
        assertNull(workshop.state.learning.solved)
        assertTrue(workshop.state.learning.worldsDone.isEmpty())
        workshop.handle(LearningEvent.WorldSolutionRequested(false))
        assertEquals("forward 1\n", workshop.state.programText)
        assertFalse(shown.help.solutionShown)
        assertEquals(listOf(task.program.name), tabs)
        workshop.handle(RunEvent.Scrubbed(0))
        workshop.handle(RunEvent.Scrubbed(30_000))
        workshop.advance(1_000)
        assertNull(workshop.state.learning.solved)
        assertTrue(workshop.state.learning.worldsDone.isEmpty())
    }

    @Test
    fun `who works in NQC is shown a solution in NQC, and solves the world with it`() {
        choose("table-edge")
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.NQC))
        workshop.handle(LearningEvent.WorldSolutionRequested(true))
        assertEquals("solution.nqc", workshop.state.programName)
        val solution = workshop.state.programText
        workshop.handle(LearningEvent.WorldSolutionRequested(false))
        assertEquals("program.nqc", workshop.state.programName)
        tries(solution)
        workshop.advance(60_000)
        assertEquals(setOf("table-edge"), workshop.state.learning.worldsDone)
    }

    @Test
    fun `who works in NQC begins in NQC, and is shown a translated solution that solves the world`() {
        choose("slalom")
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.NQC))
        assertTrue(shown.canStart)
        workshop.handle(LearningEvent.WorldProgramRequested)
        assertEquals("slalom.nqc", workshop.state.programName)
        assertTrue("task main()" in workshop.state.programText, workshop.state.programText)
        assertFalse(shown.canStart)
        workshop.handle(LearningEvent.WorldSolutionRequested(true))
        assertEquals("solution.nqc", workshop.state.programName)
        assertTrue(shown.help.solutionShown)
        val solution = workshop.state.programText
        workshop.handle(LearningEvent.WorldSolutionRequested(false))
        assertEquals("slalom.nqc", workshop.state.programName)
        tries(solution)
        workshop.advance(60_000)
        assertEquals(setOf("slalom"), workshop.state.learning.worldsDone)
    }

    @Test
    fun `a mistake is told although an earlier program has solved the world`() {
        choose("line-loop")
        tries(assertNotNull(shown.task.solutions.find { it.name.endsWith(".robo") }).text)
        workshop.advance(60_000)
        assertEquals(WorkshopStatus.Solved, workshop.state.status)
        workshop.handle(ProgramEvent.ProgramEdited("forwrd 3\n"))
        runBlocking { workshop.compilePrograms() }
        assertEquals(WorkshopStatus.HasErrors(1, null), workshop.state.status)
    }

    @Test
    fun `a translated program that the pupil left unchanged leaves with its world`() {
        choose("slalom")
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.NQC))
        workshop.handle(LearningEvent.WorldProgramRequested)
        choose("square")
        assertFalse("slalom.nqc" in workshop.project.robots.first().programs.map { it.name })
    }

    @Test
    fun `a solved world leads to its harder variations, with the program that solved it`() {
        choose("square")
        tries(task.solution.text)
        assertEquals(square.harder, workshop.state.learning.solved?.harder)
        val harder = square.harder.first()
        choose(harder.name)
        assertEquals(harder.world(workshop.language).title, workshop.state.world.title)
        assertEquals(task.solution.text, workshop.state.programText)
        assertEquals(harder, shown.world)
        tries(assertNotNull(harder.lesson).solution.text)
        assertEquals(setOf("square", harder.name), workshop.state.learning.worldsDone)
        assertEquals(square.harder.drop(1), workshop.state.learning.solved?.harder)
    }

    @Test
    fun `what a world brought and the pupil left unchanged leaves with it`() {
        workshop.handle(ProgramEvent.ProgramEdited("forward 7\n"))
        for (name in listOf("square", "maze", "nxt-map", "nxt-lines", "sumo", "nxt-wall")) {
            choose(name)
            workshop.handle(LearningEvent.WorldProgramRequested)
            workshop.handle(LearningEvent.WorldSolutionRequested(true))
            assertTrue(shown.help.solutionShown, name)
            assertEquals(listOf("square.robo", shown.task.program.name), tabs.take(2), name)
            assertEquals(3, tabs.size, name)
        }
        choose("plain")
        assertEquals(listOf("square.robo"), tabs)
        assertEquals("forward 7\n", workshop.state.programText)
    }

    @Test
    fun `what the pupil changed stays in every other world`() {
        choose("maze")
        workshop.handle(LearningEvent.WorldSolutionRequested(true))
        workshop.handle(ProgramEvent.ProgramEdited("forward 9\n"))
        choose("nxt-map")
        assertEquals(listOf("solution.robo"), tabs)
        assertEquals("forward 9\n", workshop.state.programText)
    }

    @Test
    fun `with five programs an unchanged one makes room, and never one of the pupil's`() {
        workshop.handle(ProgramEvent.ProgramEdited("forward 7\n"))
        choose("maze")
        workshop.handle(LearningEvent.WorldProgramRequested)
        repeat(3) { workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.ROBOLANG)) }
        val own = tabs - shown.task.program.name
        assertEquals(5, tabs.size)
        workshop.handle(LearningEvent.WorldSolutionRequested(true))
        assertTrue(shown.help.solutionShown)
        assertEquals(own + "solution.robo", tabs)
        workshop.handle(ProgramEvent.ProgramEdited("forward 9\n"))
        val all = workshop.state.programs.programs
        workshop.handle(LearningEvent.WorldSolutionRequested(true))
        assertEquals(Notice.NoSlotForTask, workshop.state.notice)
        assertEquals(all, workshop.state.programs.programs)
    }

    @Test
    fun `a pupil who has only what a world brought begins the next one with what that brings`() {
        choose("maze")
        workshop.handle(LearningEvent.WorldSolutionRequested(true))
        workshop.handle(ProgramEvent.ProgramClosed(0))
        assertEquals(listOf("solution.robo"), tabs)
        choose("square")
        assertEquals(listOf(task.program.name), tabs)
    }
}
