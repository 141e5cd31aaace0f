package robotran.workshop.run

import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.brick.log.CallLogFilter
import robotran.brick.program.StepKind
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.runcontrol.RunSpeed
import robotran.simulation.Breakpoint
import robotran.simulation.SessionInput
import robotran.simulation.state.GoalStatus
import robotran.tinyvm.config.TinyVmMode
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.Sharing
import robotran.workshop.service.asProject
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.WorkshopStatus
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class RunStateHolderTest {
    private val shared = mutableListOf<String>()
    private val platform = MemoryPlatform(
        sharing = object : Sharing {
            override suspend fun share(text: String): Boolean = shared.add(text)
        },
    )
    private val workshop = runBlocking { openWorkshop(listOf(Program.of("way.robo", WAY)), platform) }
    private var nanoseconds = 0L

    @AfterTest
    fun close() = workshop.close()

    private val run get() = workshop.state.run

    private fun did(vararg events: RunEvent) = events.forEach(workshop::handle)

    /** Simulates frames until nothing is awake, at most for [milliseconds]. */
    private fun frames(milliseconds: Int = 10_000) = repeat(milliseconds / FRAME) {
        nanoseconds += FRAME * 1_000_000L
        if (workshop.state.awake) workshop.frame(nanoseconds)
    }

    @Test
    fun `time stands still while paused, and goes on where it was`() {
        did(RunEvent.RunPressed)
        frames(1_000)
        did(RunEvent.PausePressed)
        val time = run.time
        assertFalse(workshop.state.awake)
        assertEquals(WorkshopStatus.Paused(2), workshop.state.status)
        frames(1_000)
        assertEquals(time, run.time)
        did(RunEvent.PausePressed)
        frames(500)
        assertTrue(run.time in time + 400..time + 500)
    }

    @Test
    fun `the goals are decided after a program in which the robot only stood`() {
        workshop.handle(LearningEvent.WorldChosen("maze"))
        workshop.handle(ProgramEvent.ProgramEdited("show 3\nwait 2 seconds\nbeep\n"))
        did(RunEvent.RunPressed)
        frames()
        assertFalse(workshop.state.awake)
        assertNotNull(run.outcome.finished)
        assertEquals(GoalStatus.FAILED, run.outcome.goals.single().status)
        assertTrue(run.shortfalls.isNotEmpty())
    }

    @Test
    fun `a step begins the program before its first line, and the next does that line`() {
        did(RunEvent.StepPressed(StepKind.INTO))
        assertEquals(WorkshopStatus.Paused(1), workshop.state.status)
        assertEquals(1, workshop.state.shownProgramRun.runningLine)
        did(RunEvent.StepPressed(StepKind.INTO))
        frames()
        assertEquals(2, workshop.state.shownProgramRun.runningLine)
        assertTrue(run.isPaused)
    }

    @Test
    fun `a run to a line stops before it`() {
        did(RunEvent.RunToLine(Breakpoint(4)))
        frames()
        assertEquals(WorkshopStatus.Paused(4), workshop.state.status)
    }

    @Test
    fun `what has changed since the last stop is lit`() {
        did(RunEvent.DrawerChosen(DrawerTab.VARIABLES), RunEvent.RunToLine(Breakpoint(4)))
        frames()
        val before = run.drawer.variables.scopes.flatMap { it.variables }
        assertEquals(listOf("side 5 false", "rounds 0 false"), before.map { "${it.name} ${it.value} ${it.changed}" })
        did(RunEvent.StepPressed(StepKind.INTO))
        frames()
        val after = run.drawer.variables.scopes.flatMap { it.variables }
        assertEquals(listOf("side 5 false", "rounds 1 true"), after.map { "${it.name} ${it.value} ${it.changed}" })
    }

    @Test
    fun `the run can be gone through back and forth and goes on where it ended`() {
        did(RunEvent.RunPressed)
        frames()
        val end = run.length
        val pose = workshop.state.session.robot.pose
        did(RunEvent.Scrubbed(500))
        assertTrue(run.inPast)
        frames(1_000)
        assertEquals(500, workshop.state.session.milliseconds)
        assertNotEquals(pose, workshop.state.session.robot.pose)
        did(RunEvent.Scrubbed(end))
        frames(1_000)
        assertEquals(pose, workshop.state.session.robot.pose)
        assertEquals(end, run.length)
        assertNull(workshop.state.notice)
    }

    @Test
    fun `whoever does something in the past begins a new run there, and is told`() {
        did(RunEvent.RunPressed)
        frames()
        did(RunEvent.Scrubbed(800))
        frames(500)
        did(RunEvent.SessionTouched(SessionInput.PlaceRobot(0, Pose(50.0, 50.0, 90.0))))
        assertTrue(workshop.state.notice != null)
        assertFalse(run.inPast)
        assertEquals(800, run.length)
        assertTrue(run.isPaused)
    }

    @Test
    fun `Stop in the past only stops looking`() {
        did(RunEvent.RunPressed)
        frames()
        val end = run.length
        did(RunEvent.Scrubbed(500))
        frames(500)
        did(RunEvent.PausePressed)
        frames(100)
        did(RunEvent.StopPressed)
        assertTrue(run.isPaused)
        assertEquals(end, run.length)
    }

    @Test
    fun `a button of the brick is answered also after somebody has looked back`() {
        did(RunEvent.RunPressed)
        frames()
        did(RunEvent.Scrubbed(run.length))
        frames(500)
        did(RunEvent.ButtonPressed(BrickButton.ON_OFF), RunEvent.ButtonReleased(BrickButton.ON_OFF))
        frames(2_000)
        assertFalse(workshop.state.session.brick.poweredOn)
    }

    @Test
    fun `a speed lasts from run to run`() {
        did(RunEvent.SpeedChosen(RunSpeed.HALF), RunEvent.RunPressed)
        frames(1_000)
        assertTrue(run.time in 450..500, "it is ${run.time}")
        did(RunEvent.SpeedChosen(RunSpeed.FASTEST))
        assertEquals(0, workshop.state.shownProgramRun.runningLine)
        frames(1_000)
        assertFalse(run.running)
        assertEquals(RunSpeed.FASTEST, run.speed)
    }

    @Test
    fun `back to the start puts the robot back and runs nothing`() {
        did(RunEvent.RunPressed)
        frames(1_000)
        did(RunEvent.StartedOver)
        frames(1_000)
        assertEquals(workshop.state.world.start, workshop.state.session.robot.pose)
        assertFalse(run.running)
    }

    @Test
    fun `a recording that came with the project is the same run again`() {
        did(RunEvent.RunPressed)
        frames(1_000)
        did(RunEvent.SessionTouched(SessionInput.PlaceRobot(0, Pose(60.0, 40.0, 90.0))))
        frames()
        val project = workshop.replay
        val report = workshop.state.session.robot
        workshop.services.editor.openProject(project)
        assertTrue(run.hasRecording)
        did(RunEvent.RecordingPlayed)
        frames()
        assertEquals(report, workshop.state.session.robot)
        assertEquals(project.inputs, workshop.inputs)
    }

    @Test
    fun `a replay runs the program that was run, whichever is shown, and a project begins with the program it says`() {
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("second.robo", "pen down\nbackward 10\npen up\nbeep")))
        did(RunEvent.RunPressed)
        frames()
        val report = workshop.state.session.robot
        workshop.handle(ProgramEvent.ProgramChosen(0))
        val replay = workshop.replay
        assertEquals(listOf(1), replay.robots.map { it.firstProgram })
        workshop.services.editor.openProject(replay)
        assertEquals(1, workshop.state.programs.shownProgram)
        workshop.handle(ProgramEvent.ProgramChosen(0))
        did(RunEvent.RecordingPlayed)
        frames()
        assertEquals(report, workshop.state.session.robot)
    }

    @Test
    fun `the ROM calls can be filtered and copied`() {
        did(RunEvent.DrawerChosen(DrawerTab.LOG), RunEvent.RunPressed)
        frames()
        val all = run.drawer.log.entries.size
        did(RunEvent.LogFiltered(CallLogFilter(text = "motor")), RunEvent.LogCopied)
        val some = run.drawer.log.entries
        assertTrue(some.isNotEmpty() && some.size < all)
        assertEquals(some.size, shared.single().lines().count { it.isNotEmpty() })
        assertTrue(workshop.state.notice != null)
    }

    @Test
    fun `how the programs run can be changed, and begins the run afresh`() {
        did(RunEvent.RunPressed)
        frames(1_000)
        did(RunEvent.RunSettingsChanged(run.settings.copy(realism = 0.5, seed = 7)))
        assertEquals(0.5, workshop.state.world.realism)
        assertEquals(7, workshop.state.world.seed)
        assertEquals(0, run.time)
        did(RunEvent.DrawerChosen(DrawerTab.WHY), RunEvent.RunPressed)
        frames()
        assertTrue(run.drawer.why.deviationCauses.isNotEmpty())
        val java = run.settings.java.copy(mode = TinyVmMode.FORGIVING)
        did(RunEvent.RunSettingsChanged(run.settings.copy(java = java)))
        assertEquals(java, workshop.project.settings.java)
    }

    @Test
    fun `Run starts all robots, and each can be looked into`() {
        val first = BuiltInWorlds.plain.robots.first()
        val other = first.copy(
            start = Pose(20.0, 55.0, 0.0),
            name = "other",
            program = "var n = 3\nforward 10\nn = 4\nforward 5",
        )
        val world = BuiltInWorlds.plain.copy(robots = listOf(first, other))
        val mine = ProjectRobot(first.name, listOf(Program.of("way.robo", WAY).asProject()))
        workshop.services.editor.openProject(Project(world, listOf(mine)))
        did(RunEvent.DebuggedRobotChosen(1), RunEvent.DrawerChosen(DrawerTab.VARIABLES), RunEvent.RunPressed)
        frames(500)
        assertTrue(workshop.state.session.robots.all { it.robot.pose != first.start && it.robot.pose != other.start })
        did(RunEvent.PausePressed)
        assertEquals(
            listOf("n 3"),
            run.drawer.variables.scopes.flatMap { it.variables }.map { "${it.name} ${it.value}" },
        )
        assertEquals(1, run.watched)
    }

    @Test
    fun `brick, status and program are those of one robot, and a breakpoint of another one brings that one`() {
        val first = BuiltInWorlds.plain.robots.first()
        val other = first.copy(start = Pose(20.0, 55.0, 0.0), name = "other", program = "forward 50\nbeep")
        val world = BuiltInWorlds.plain.copy(robots = listOf(first, other))
        val mine = ProjectRobot(first.name, listOf(Program.of("way.robo", WAY).asProject()))
        workshop.services.editor.openProject(Project(world, listOf(mine)))
        workshop.handle(ProgramEvent.BreakpointToggled(4))
        workshop.handle(ProgramEvent.RobotChosen("other"))
        assertEquals(1, run.watched)
        did(RunEvent.RunPressed)
        frames(500)
        assertEquals(WorkshopStatus.Running(1), workshop.state.status)
        frames(6_000)
        assertEquals(WorkshopStatus.Paused(4), workshop.state.status)
        assertEquals(first.name to 0, workshop.state.programs.shownRobot to run.watched)
        assertEquals(4, workshop.state.shownProgramRun.runningLine)
        did(RunEvent.DebuggedRobotChosen(1))
        assertEquals("other", workshop.state.programs.shownRobot)
        assertEquals(WorkshopStatus.Paused(1), workshop.state.status)
    }

    private companion object {
        const val FRAME = 16
        const val WAY = "var side = 5\nforward 30\nvar rounds = 0\nrounds = rounds + 1\nforward side\nbeep\nshow rounds"
    }
}
