package robotran.workshop

import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.brick.state.RunState
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.state.Pane
import robotran.workshop.state.WorkshopStatus
import kotlin.math.abs
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

class WorkshopTest {
    private val workshop = runBlocking { openWorkshop() }

    @AfterTest
    fun close() = workshop.close()

    @Test
    fun `it opens with the square, a brick that is on and an empty sheet`() {
        val state = workshop.state
        assertEquals("square.robo", state.programName)
        assertTrue("forward 20" in state.programText)
        assertTrue(state.session.brick.poweredOn)
        assertEquals(0.0, state.session.ink.lengthCentimetres)
        assertEquals(WorkshopStatus.Ready, state.status)
    }

    @Test
    fun `Run in the run bar draws a square and comes back`() {
        val start = workshop.state.session.robot.pose
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(SQUARE)
        val session = workshop.state.session
        assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
        assertTrue(abs(session.ink.lengthCentimetres - 80) < 1, "drew ${session.ink.lengthCentimetres} cm")
        assertTrue(
            abs(session.robot.pose.x - start.x) < 0.5 && abs(session.robot.pose.y - start.y) < 0.5,
            "is at ${session.robot.pose}",
        )
    }

    @Test
    fun `the brick's own Run starts when it is let go`() {
        workshop.handle(RunEvent.ButtonPressed(BrickButton.RUN))
        workshop.advance(500)
        assertFalse(workshop.state.running)
        assertEquals(setOf(BrickButton.RUN), workshop.state.down)
        workshop.handle(RunEvent.ButtonReleased(BrickButton.RUN))
        workshop.advance(1)
        assertTrue(workshop.state.running)
        assertEquals(emptySet(), workshop.state.down)
    }

    @Test
    fun `the brick's own Run carries on from where the robot stands`() {
        workshop.handle(ProgramEvent.ProgramEdited("pen down\nforward 5"))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(2000)
        val first = workshop.state.session
        tapRun()
        workshop.advance(2000)
        val second = workshop.state.session
        assertEquals(10.0, second.robot.pose.x - first.robot.pose.x + 5.0, absoluteTolerance = 0.2)
        assertTrue(second.ink.lengthCentimetres > first.ink.lengthCentimetres + 4)
    }

    @Test
    fun `Run in the run bar puts the robot back on a clean sheet`() {
        val start = workshop.state.session.robot.pose
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1500)
        assertTrue(workshop.state.session.ink.lengthCentimetres > 1)
        workshop.handle(RunEvent.RunPressed)
        assertEquals(0.0, workshop.state.session.ink.lengthCentimetres)
        assertEquals(start, workshop.state.session.robot.pose)
        workshop.advance(10)
        assertTrue(workshop.state.running)
    }

    @Test
    fun `the brick's own Run loads a changed program and begins afresh`() {
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(SQUARE)
        workshop.handle(ProgramEvent.ProgramEdited("forward 10"))
        assertEquals(WorkshopStatus.Changed, workshop.state.status)
        val start = workshop.state.world.start
        tapRun()
        workshop.advance(2000)
        assertEquals(0.0, workshop.state.session.ink.lengthCentimetres)
        assertEquals(start.x + 10, workshop.state.session.robot.pose.x, absoluteTolerance = 0.2)
        assertFalse(workshop.state.changed)
    }

    @Test
    fun `with a mistake in the text nothing runs and the mistake is pointed out`() {
        workshop.handle(ProgramEvent.ProgramEdited("pen down\nforwrd 20"))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1000)
        tapRun()
        workshop.advance(1000)
        val state = workshop.state
        assertEquals(RunState.Idle, state.session.brick.run)
        assertEquals(WorkshopStatus.HasErrors(line = 2), state.status)
        assertTrue(state.programs.errorPointedOut)
        assertEquals(Pane.PROGRAM, state.pane)
        assertEquals(state.world.start, state.session.robot.pose)
    }

    @Test
    fun `an empty program does not run and says so`() {
        workshop.handle(ProgramEvent.ProgramEdited("  \n"))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(100)
        assertEquals(WorkshopStatus.Empty, workshop.state.status)
        assertEquals(RunState.Idle, workshop.state.session.brick.run)
    }

    @Test
    fun `a fix mends its mistake`() {
        workshop.handle(ProgramEvent.ProgramEdited("pen down\r\n  forwrd 20 // there"))
        workshop.handle(ProgramEvent.FixApplied(workshop.state.diagnostics.single()))
        assertEquals("pen down\n  forward 20 // there", workshop.state.programText)
        assertEquals(emptyList(), workshop.state.diagnostics)
    }

    @Test
    fun `Stop ends the program where it is`() {
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1500)
        workshop.handle(RunEvent.StopPressed)
        workshop.advance(200)
        val stopped = workshop.state.session.robot.pose
        workshop.advance(1000)
        assertEquals(WorkshopStatus.Ended(stopped = true), workshop.state.status)
        val later = workshop.state.session.robot.pose
        assertEquals(stopped.x, later.x, absoluteTolerance = 0.01)
        assertEquals(stopped.heading, later.heading, absoluteTolerance = 0.01)
    }

    @Test
    fun `On-Off with Run held down ends the program`() {
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1500)
        workshop.handle(RunEvent.ButtonPressed(BrickButton.RUN))
        workshop.handle(RunEvent.ButtonPressed(BrickButton.ON_OFF))
        workshop.advance(50)
        workshop.handle(RunEvent.ButtonReleased(BrickButton.ON_OFF))
        workshop.handle(RunEvent.ButtonReleased(BrickButton.RUN))
        workshop.advance(50)
        assertEquals(WorkshopStatus.Ended(stopped = true), workshop.state.status)
        assertTrue(workshop.state.session.brick.poweredOn)
    }

    @Test
    fun `Run in the run bar switches the brick on`() {
        tap(BrickButton.ON_OFF)
        workshop.advance(100)
        assertEquals(WorkshopStatus.Off, workshop.state.status)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(100)
        assertIs<WorkshopStatus.Running>(workshop.state.status)
    }

    @Test
    fun `a program that never ends can be stopped and left`() {
        workshop.handle(ProgramEvent.ProgramEdited("repeat 2000000000 times\nend"))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(2000)
        assertTrue(workshop.state.running)
        workshop.handle(RunEvent.StopPressed)
        workshop.advance(10)
        assertFalse(workshop.state.running)
    }

    @Test
    fun `on a phone Run shows the world`() {
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        workshop.handle(RunEvent.RunPressed)
        assertEquals(Pane.WORLD, workshop.state.pane)
    }

    private fun tapRun() = tap(BrickButton.RUN)

    private fun tap(button: BrickButton) {
        workshop.handle(RunEvent.ButtonPressed(button))
        workshop.handle(RunEvent.ButtonReleased(button))
    }

    private companion object {
        /** A virtual time in milliseconds that is long enough for the square. */
        const val SQUARE = 10_000
    }
}
