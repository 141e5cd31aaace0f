package robotran.workshop

import kotlinx.coroutines.runBlocking
import robotran.blockediting.BlockRun
import robotran.language.ProgramLanguage
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.simulation.Breakpoint
import robotran.workshop.blocks.DragPayload
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.programs.ProgramsStateHolder
import robotran.workshop.state.WorkshopStatus
import robotran.world.LightFacing
import robotran.world.RobotColour
import robotran.world.RobotPlacement
import robotran.world.geometry.Pose
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

class SeveralRobotsTest {
    private val workshop = runBlocking { openWorkshop() }

    @AfterTest
    fun close() = workshop.close()

    private fun open(ownProgram: String?) {
        val world = workshop.state.world
        val red = RobotPlacement(Pose(20.0, 20.0, 0.0), "red", RobotColour.RED, program = ownProgram)
        workshop.services.editor.openProject(Project(world.copy(robots = world.robots + red)))
    }

    @Test
    fun `each robot has programs of its own, first what the world gives it`() {
        open("forward 5")
        workshop.handle(ProgramEvent.RobotChosen("red"))
        assertEquals("forward 5", workshop.state.programText)
        assertTrue(workshop.state.programs.isWorldsOwn)
        assertTrue(workshop.project.robots.none { it.name == "red" })
        workshop.handle(ProgramEvent.ProgramEdited("backward 5"))
        assertFalse(workshop.state.programs.isWorldsOwn)
        assertEquals(
            "backward 5",
            workshop.project.robots.single { it.name == "red" }.programs.single().files.single().text,
        )
        workshop.handle(ProgramEvent.RobotChosen("yellow"))
        assertEquals("square.robo", workshop.state.programName)
    }

    @Test
    fun `all robots drive, also one whose program is not shown`() {
        open(null)
        workshop.handle(ProgramEvent.RobotChosen("red"))
        workshop.handle(ProgramEvent.ProgramEdited("forward 5"))
        workshop.handle(ProgramEvent.RobotChosen("yellow"))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(100)
        assertTrue(workshop.state.running)
        assertEquals(2, workshop.state.session.robots.size)
    }

    @Test
    fun `a block that runs at once drives the robot whose program is shown`() {
        open("forward 5\nbeep")
        workshop.handle(ProgramEvent.RobotChosen("red"))
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        val blocks = checkNotNull(workshop.state.programs.blocks)
        val before = workshop.state.session.robots
        workshop.handle(BlockEvent.SnippetRequested(DragPayload.Blocks(BlockRun(blocks.program.blocks.first().id))))
        workshop.advance(100)
        assertEquals(1, workshop.state.shownProgramRun.runningLine)
        workshop.advance(2_000)
        val after = workshop.state.session.robots
        assertEquals(before[0].robot.pose, after[0].robot.pose)
        assertTrue(before[1].robot.pose != after[1].robot.pose)
        workshop.handle(ProgramEvent.RobotChosen("yellow"))
        assertEquals(0, workshop.state.shownProgramRun.runningLine)
    }

    @Test
    fun `the status tells of the robot whose block runs at once, until Run is pressed`() {
        open("var zero = 0\nforward 5\nshow 5 / zero")
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(100)
        workshop.handle(RunEvent.StopPressed)
        workshop.advance(100)
        assertEquals(true, (workshop.state.status as WorkshopStatus.Ended).stopped)
        workshop.handle(ProgramEvent.RobotChosen("red"))
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        val (_, forward, division) = checkNotNull(workshop.state.programs.blocks).program.blocks
        workshop.handle(BlockEvent.SnippetRequested(DragPayload.Blocks(BlockRun(forward.id))))
        workshop.advance(100)
        assertEquals(WorkshopStatus.Running(0), workshop.state.status)
        workshop.advance(2_000)
        assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
        workshop.handle(BlockEvent.SnippetRequested(DragPayload.Blocks(BlockRun(division.id))))
        workshop.advance(500)
        assertIs<WorkshopStatus.Failed>(workshop.state.status)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(100)
        assertTrue((workshop.state.status as WorkshopStatus.Running).line > 0)
    }

    @Test
    fun `a mistake in another robot's program is shown before anything runs`() {
        open("beep")
        workshop.handle(ProgramEvent.RobotChosen("red"))
        workshop.handle(ProgramEvent.ProgramEdited("bep"))
        workshop.handle(ProgramEvent.RobotChosen("yellow"))
        workshop.handle(RunEvent.RunPressed)
        assertFalse(workshop.state.running)
        assertEquals("red", workshop.state.programs.shownRobot)
        assertTrue(workshop.state.programs.errorPointedOut)
    }

    @Test
    fun `programs stay with their robots when the world changes`() {
        open("beep")
        workshop.handle(ProgramEvent.ProgramEdited("forward 7"))
        workshop.services.editor.changeWorld(workshop.state.world.copy(title = "Another"))
        assertEquals("forward 7", workshop.state.programText)
        workshop.handle(ProgramEvent.RobotChosen("red"))
        assertEquals("beep", workshop.state.programText)
    }

    @Test
    fun `the light sensor looks where the program says if the world leaves it open`() {
        val program = "robot\n  light sensor on 2 facing forward\nend\nshow light"
        workshop.handle(ProgramEvent.ProgramEdited(program))
        val place = workshop.state.world.robots.first()
        val holder = ProgramsStateHolder(workshop.project, workshop.services)
        assertEquals(LightFacing.FORWARD, holder.loads(workshop.state.world, listOf(0)).first().lightFacing)
        assertEquals(setOf<Breakpoint>(), holder.breakpoints(place.name, 0))
    }

    @Test
    fun `breakpoints are told with their files where there are several`() {
        workshop.handle(ProgramEvent.BreakpointToggled(2))
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        workshop.handle(ProgramEvent.BreakpointToggled(4))
        workshop.handle(ProgramEvent.BreakpointToggled(999))
        assertEquals(setOf(4), workshop.state.programs.breakpoints)
        workshop.handle(ProgramEvent.BreakpointToggled(4))
        assertEquals(emptySet(), workshop.state.programs.breakpoints)
    }
}
