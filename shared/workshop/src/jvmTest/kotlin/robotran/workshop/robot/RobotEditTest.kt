package robotran.workshop.robot

import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotHandle
import robotran.robotediting.RobotItem
import robotran.workshop.Workshop
import robotran.workshop.documents.Machine
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.platform.OpenedFile
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.WorldRoomEvent
import robotran.workshop.state.Notice
import robotran.workshop.state.RobotEditState
import robotran.workshop.state.WorkshopStatus
import robotran.world.ReadyRobots
import robotran.world.RobotPlacement
import robotran.world.Wall
import robotran.world.file.RobotFileResult
import robotran.world.file.readRobot
import robotran.world.file.writeRobot
import robotran.world.geometry.Point
import robotran.world.robot.RobotError
import robotran.worldediting.WorldEdit
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class RobotEditTest {
    private val machine = Machine()
    private val windows = mutableListOf(machine.window())
    private val workshop get() = windows.last()

    @AfterTest
    fun close() = windows.forEach(Workshop::close)

    private val bench: RobotEditState get() = assertNotNull(workshop.state.robotEdit)
    private val robot: RobotPlacement get() = workshop.project.world.robots.first()

    private fun make(vararg edits: RobotEdit) = edits.forEach { workshop.handle(RobotEditEvent.Edited(it)) }

    private fun open() = workshop.handle(RobotEditEvent.BenchOpened())

    private fun done() = workshop.handle(RobotEditEvent.BenchClosed)

    /** Both bumpers of an NXT on one port. */
    private fun makeImpossible() = make(
        RobotEdit.Replace(ReadyRobots.NXT_PENBOT),
        RobotEdit.Choose(RobotElement.Part(0)),
        RobotEdit.SetPort(2),
    )

    @Test
    fun `from the menu the workbench opens and leads back to the workshop with the robot in its world`() {
        open()
        assertEquals(ReadyRobots.RCX_PENBOT, bench.editing.robot)
        make(RobotEdit.Replace(ReadyRobots.SUMO))
        assertEquals(ReadyRobots.SUMO, robot.description)
        done()
        assertNull(workshop.state.robotEdit)
        assertNull(workshop.state.worldEdit)
        assertEquals(ReadyRobots.SUMO, workshop.state.world.robots.first().description)
    }

    @Test
    fun `a part that is dragged is one step, the world is saved once, and others hear of it once`() {
        open()
        val steps = bench.editing.history
        val heard = mutableListOf<RoomEvent>()
        workshop.services.events.subscribe { heard += it }
        val part = RobotHandle.Body(RobotElement.Part(0))
        make(RobotEdit.StartDrag(part, Point(8.0, 0.0)))
        repeat(5) { make(RobotEdit.DragTo(Point(8.0 + it, 1.0))) }
        assertEquals(6, heard.size, "a move is one event")
        assertEquals(setOf<RoomEvent>(ProjectRoomEvent.Touched), heard.toSet())
        assertEquals(steps, bench.editing.history)
        heard.clear()
        make(RobotEdit.Drop)
        assertEquals(1, heard.count { it == WorldRoomEvent.Edited })
        assertEquals(1, heard.count { it is ProjectRoomEvent.WorldSaved })
        assertEquals(steps.past.size + 1, bench.editing.history.past.size)
        make(RobotEdit.Undo)
        assertEquals(ReadyRobots.RCX_PENBOT, bench.editing.robot)
    }

    @Test
    fun `in the world editor all of a visit is one step of undo`() {
        workshop.handle(WorldEditEvent.EditorOpened)
        open()
        make(RobotEdit.Replace(ReadyRobots.SUMO), RobotEdit.Add(RobotItem.COLOUR), RobotEdit.Add(RobotItem.CASTER))
        done()
        val editor = assertNotNull(workshop.state.worldEdit)
        assertEquals(4, editor.world.robots.first().description.parts.size)
        workshop.handle(WorldEditEvent.Edited(WorldEdit.Undo))
        assertEquals(ReadyRobots.RCX_PENBOT, robot.description)
    }

    @Test
    fun `a drag changes the world when it ends`() {
        open()
        make(
            RobotEdit.Replace(ReadyRobots.SUMO),
            RobotEdit.StartDrag(RobotHandle.Body(RobotElement.Part(2)), Point(8.0, 0.0)),
            RobotEdit.DragTo(Point(8.0, 2.0)),
        )
        assertEquals(ReadyRobots.SUMO, robot.description)
        make(RobotEdit.Drop)
        assertFalse(robot.description == ReadyRobots.SUMO)
    }

    @Test
    fun `undo leads back over a whole visit, also in the next one`() {
        open()
        make(RobotEdit.Replace(ReadyRobots.SUMO), RobotEdit.Add(RobotItem.COLOUR))
        done()
        open()
        make(RobotEdit.Undo, RobotEdit.Undo)
        assertEquals(ReadyRobots.RCX_PENBOT, robot.description)
    }

    @Test
    fun `an impossible robot is a draft, which does not drive, and a run is refused in a sentence`() {
        open()
        makeImpossible()
        assertEquals(ReadyRobots.NXT_PENBOT, robot.description)
        assertEquals(listOf(2, 2, 3, 4), robot.draft?.parts?.map { it.port })
        done()
        assertNull(workshop.state.worldEdit)
        workshop.handle(ProgramEvent.ProgramEdited("forward 5"))
        val status = assertIs<WorkshopStatus.RobotImpossible>(workshop.state.status)
        assertIs<RobotError.PortTaken>(status.draft.error)
        workshop.handle(RunEvent.RunPressed)
        assertIs<Notice.RobotImpossible>(workshop.state.notice)
        assertFalse(workshop.state.running)
        workshop.advance(500)
        assertFalse(workshop.state.running)
    }

    @Test
    fun `Done with an impossible robot tells that it is a draft and leads back to the workbench, as Run does`() {
        open()
        makeImpossible()
        done()
        val kept = assertIs<Notice.RobotKeptAsDraft>(workshop.state.notice)
        assertIs<RobotError.PortTaken>(kept.draft.error)
        assertEquals(robot.draft, kept.draft.draft)
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertFalse(bench.editing.isPossible)
        assertNull(workshop.state.notice)
        done()
        workshop.handle(ProgramEvent.ProgramEdited("forward 5"))
        workshop.handle(RunEvent.RunPressed)
        assertIs<Notice.RobotImpossible>(workshop.state.notice)
        workshop.handle(WorkshopEvent.NoticeTaken)
        make(RobotEdit.Choose(RobotElement.Part(0)), RobotEdit.SetPort(1))
        done()
        assertNull(workshop.state.notice)
        assertEquals(WorkshopStatus.Ready, workshop.state.status)
    }

    @Test
    fun `the world editor's Done tells it, too`() {
        workshop.handle(WorldEditEvent.EditorOpened)
        open()
        makeImpossible()
        done()
        workshop.handle(WorkshopEvent.NoticeDismissed)
        workshop.handle(WorldEditEvent.EditorClosed)
        assertIs<Notice.RobotKeptAsDraft>(workshop.state.notice)
    }

    @Test
    fun `ESCAPE alone during a run tells once what ends a program`() {
        open()
        make(RobotEdit.Replace(ReadyRobots.NXT_PENBOT))
        done()
        workshop.handle(ProgramEvent.ProgramEdited("forward 500"))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(500)
        assertTrue(workshop.state.running)
        tap(BrickButton.ESCAPE)
        assertEquals(Notice.EscapeAlone, workshop.state.notice)
        workshop.handle(WorkshopEvent.NoticeDismissed)
        tap(BrickButton.ESCAPE)
        assertNull(workshop.state.notice)
        assertTrue(workshop.state.running)
    }

    private fun tap(button: BrickButton) {
        workshop.handle(RunEvent.ButtonPressed(button))
        workshop.advance(50)
        workshop.handle(RunEvent.ButtonReleased(button))
        workshop.advance(50)
    }

    @Test
    fun `the brick's own button refuses it, too`() {
        open()
        makeImpossible()
        done()
        workshop.handle(RunEvent.ButtonPressed(BrickButton.ENTER))
        workshop.advance(300)
        assertIs<Notice.RobotImpossible>(workshop.state.notice)
        assertFalse(workshop.state.running)
    }

    @Test
    fun `once it is mended it drives`() {
        open()
        makeImpossible()
        done()
        open()
        assertEquals(1, bench.editing.errors.size)
        make(RobotEdit.Choose(RobotElement.Part(0)), RobotEdit.SetPort(1))
        assertNull(robot.draft)
        done()
        workshop.handle(ProgramEvent.ProgramEdited("forward 5"))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(200)
        assertTrue(workshop.state.running)
    }

    @Test
    fun `nothing is lost when the app ends in the workbench`() {
        open()
        makeImpossible()
        runBlocking { workshop.closeDocument() }
        windows += machine.window()
        assertEquals(listOf(2, 2, 3, 4), robot.draft?.parts?.map { it.port })
        open()
        assertFalse(bench.editing.isPossible)
    }

    @Test
    fun `a robot is saved by itself and opened again`() {
        machine.files.location = "/home/sumo.robot.json"
        open()
        make(RobotEdit.Replace(ReadyRobots.SUMO), RobotEdit.Add(RobotItem.COLOUR))
        workshop.handle(RobotEditEvent.SaveRequested)
        val built = bench.editing.robot
        assertEquals(Notice.FileSaved("sumo.robot.json"), workshop.state.notice)
        assertEquals("Sumo robot 2.robot.json", machine.files.suggestion)
        val bytes = machine.files.disk.getValue("/home/sumo.robot.json")
        assertEquals(RobotFileResult.Success(built), readRobot(bytes, Language.ENGLISH))
        make(RobotEdit.Replace(ReadyRobots.RCX_PENBOT))
        machine.files.chosen = listOf(OpenedFile("sumo.robot.json", bytes))
        workshop.handle(RobotEditEvent.OpenRequested)
        assertEquals(built, robot.description)
    }

    @Test
    fun `an impossible robot is not saved, and a file without a robot is refused in a sentence`() {
        machine.files.location = "/home/sumo.robot.json"
        open()
        makeImpossible()
        workshop.handle(RobotEditEvent.SaveRequested)
        assertTrue(bench.isSavingRefused)
        assertTrue(machine.files.disk.isEmpty())
        machine.files.chosen = listOf(OpenedFile("sumo.robot.json", "{}".encodeToByteArray()))
        workshop.handle(RobotEditEvent.OpenRequested)
        assertTrue(assertNotNull(bench.fileError).isNotBlank())
        machine.files.chosen =
            listOf(OpenedFile("sumo.robot.json", writeRobot(ReadyRobots.SUMO).encodeToByteArray()))
        workshop.handle(RobotEditEvent.OpenRequested)
        assertNull(bench.fileError)
        assertEquals(ReadyRobots.SUMO, bench.editing.robot)
    }

    @Test
    fun `a robot that has no room where it stands keeps the world editor open`() {
        workshop.services.editor.changeWorld(
            workshop.project.world.let { world ->
                val start = world.robots.first().start
                val wall = Wall(Point(start.x - 5, start.y + 8.6), Point(start.x + 5, start.y + 8.6), 1.0)
                world.copy(walls = listOf(wall))
            },
        )
        open()
        make(RobotEdit.Replace(ReadyRobots.SUMO))
        done()
        assertNull(workshop.state.robotEdit)
        assertTrue(assertNotNull(workshop.state.worldEdit).hasFailedToClose)
    }
}
