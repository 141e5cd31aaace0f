package robotran.workshop.blocks

import robotran.blockediting.BlockEditError
import robotran.blockediting.BlockRun
import robotran.brick.state.RunState
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.state.GoalCount
import robotran.workshop.state.Pane
import robotran.workshop.state.WorkshopStatus
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Tests blocks that run at once. */
class SnippetRequestedTest {
    private val OnBlocks.pose: Pose get() = workshop.state.session.robot.pose
    private val OnBlocks.litLine: Int get() = workshop.state.shownProgramRun.runningLine

    private fun OnBlocks.doNow(words: String) =
        send(BlockEvent.SnippetRequested(DragPayload.Blocks(BlockRun(block(words)))))

    private fun OnBlocks.doPaletteNow(id: String) = send(BlockEvent.SnippetRequested(DragPayload.New(fromPalette(id))))

    @Test
    fun `a block runs from where the robot stands, and its line is lit`() = onBlocks(PROGRAM) {
        workshop.handle(RunEvent.StartedOver)
        val start = pose
        doNow("forward side")
        assertEquals(Pane.WORLD, workshop.state.pane)
        workshop.advance(100)
        assertEquals(3, litLine)
        assertEquals(WorkshopStatus.Running(0), workshop.state.status)
        workshop.advance(3_000)
        val middle = pose
        assertNotEquals(start, middle)
        assertEquals(WorkshopStatus.Ended(stopped = false, GoalCount()), workshop.state.status)
        assertEquals(PROGRAM, text)
        doNow("forward side")
        workshop.advance(3_000)
        assertNotEquals(middle, pose)
    }

    @Test
    fun `Run afterwards begins at the start as ever`() = onBlocks(PROGRAM) {
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(8_000)
        val ran = workshop.state.session
        doPaletteNow("turn")
        workshop.advance(3_000)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(8_000)
        assertEquals(ran.robot, workshop.state.session.robot)
        assertEquals(ran.ink.lengthCentimetres, workshop.state.session.ink.lengthCentimetres)
        assertFalse(workshop.state.session.brick.isSnippet)
    }

    @Test
    fun `a block of the palette lights no line`() = onBlocks(PROGRAM) {
        doPaletteNow("move")
        workshop.advance(100)
        assertEquals(0, litLine)
        assertIs<RunState.Running>(workshop.state.session.brick.run)
    }

    @Test
    fun `an edit puts out the line, and the block runs on`() = onBlocks(PROGRAM) {
        doNow("forward side")
        workshop.advance(100)
        take("beep")
        assertEquals(0, litLine)
        assertTrue(workshop.state.running)
    }

    @Test
    fun `a failure of a block says so, though the program has not run since it was changed`() =
        onBlocks("var zero = 0\nshow 5 / zero\n") {
            doNow("show 5 / zero")
            workshop.advance(500)
            assertTrue(workshop.state.changed)
            assertEquals(0, assertIs<WorkshopStatus.Failed>(workshop.state.status).line)
            assertEquals(2, workshop.state.shownProgramRun.failure?.sourceLine)
        }

    @Test
    fun `a running program is ended first`() = onBlocks("repeat forever\n  forward 5\nend\nbeep\n") {
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(500)
        doNow("beep")
        workshop.advance(1_000)
        assertFalse(workshop.state.running)
    }

    @Test
    fun `an endless loop is ended by Stop`() = onBlocks("repeat forever\n  forward 5\nend\n") {
        doNow("repeat forever")
        workshop.advance(20_000)
        assertTrue(workshop.state.stoppable)
        workshop.handle(RunEvent.StopPressed)
        workshop.advance(10)
        assertFalse(workshop.state.running)
    }

    @Test
    fun `time can be gone back and forth over it`() = onBlocks(PROGRAM) {
        doNow("forward side")
        workshop.advance(4_000)
        val end = pose
        workshop.handle(RunEvent.Scrubbed(0))
        while (workshop.state.run.isSeeking) workshop.advance(1_000)
        assertNotEquals(end, pose)
        workshop.handle(RunEvent.Scrubbed(500))
        while (workshop.state.run.isSeeking) workshop.advance(1_000)
        assertEquals(3, litLine)
        workshop.handle(RunEvent.PausePressed)
        workshop.advance(3_500)
        assertEquals(end, pose)
    }

    @Test
    fun `a breakpoint in it stops it`() = onBlocks(PROGRAM) {
        send(ProgramEvent.BreakpointToggled(4))
        doNow("repeat 4 times")
        workshop.advance(5_000)
        assertTrue(workshop.state.run.isPaused)
        assertEquals(4, litLine)
    }

    @Test
    fun `a replay has only what came before it`() = onBlocks(PROGRAM) {
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(500)
        val before = workshop.inputs
        doPaletteNow("turn")
        workshop.advance(500)
        workshop.handle(RunEvent.StopPressed)
        assertEquals(before, workshop.replay.inputs)
        assertEquals(before.size + 2, workshop.inputs.size)
    }

    @Test
    fun `what cannot run says why, and nothing runs`() = onBlocks("for i from 1 to 3\n  forward i\nend\nforwrd 20\n") {
        val start = pose
        doNow("forward i")
        assertEquals(BlockEditError.ValueUnknown("i"), state.error)
        doNow("forwrd 20")
        assertEquals(4, (state.error as BlockEditError.CompileError).line)
        workshop.advance(1_000)
        assertEquals(start, pose)
        doNow("for i from 1 to 3")
        assertNull(state.error)
        workshop.advance(1_000)
        assertNotEquals(start, pose)
    }

    private companion object {
        const val PROGRAM = "var side = 10\nrepeat 4 times\n  forward side\n  turn left 90\nend\npen down\n"
    }
}
