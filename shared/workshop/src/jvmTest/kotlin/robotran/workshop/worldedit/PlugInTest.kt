package robotran.workshop.worldedit

import kotlinx.coroutines.runBlocking
import robotran.workshop.Workshop
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.Notice
import robotran.world.PortSensor
import robotran.world.RobotPlacement
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.PaletteItem
import robotran.worldediting.WorldEdit
import robotran.worldediting.piece
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** A sensor that a program lacks is plugged in by changing the world. */
class PlugInTest {
    private val workshop = runBlocking { openWorkshop() }

    @AfterTest
    fun close() = workshop.close()

    private val Workshop.ports get() = project.world.robots.first().ports

    /** Runs a program that feels with the left bumper in a world whose robot has only the right one. */
    private fun runWithoutLeftBumper() =
        runWith(listOf(emptyList(), listOf(PortSensor.LIGHT), listOf(PortSensor.RIGHT_BUMPER)), LEFT)

    private fun runWith(ports: List<List<PortSensor>>, program: String) {
        val robots = BuiltInWorlds.plain.robots.map { it.withPorts(ports) }
        workshop.services.editor.changeWorld(BuiltInWorlds.plain.copy(robots = robots))
        workshop.handle(ProgramEvent.ProgramEdited(program))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(300)
    }

    private fun plugIn() {
        val run = workshop.state.shownProgramRun
        workshop.handle(WorldEditEvent.SensorsPluggedIn(run.robot, checkNotNull(run.missingSensors)))
    }

    @Test
    fun `a program that expects a bumper where none is says so once, at the top of all remarks`() {
        runWithoutLeftBumper()
        val run = workshop.state.shownProgramRun
        assertEquals(listOf(1), run.missingSensors?.sensors?.map { it.port })
        assertContains(run.warnings.first().message, "touch sensor is missing on port 1")
        assertEquals(1, workshop.state.run.marks.count { it.text.contains("touch sensor") })
    }

    @Test
    fun `what is plugged in is in the world, and the next run has it`() {
        runWithoutLeftBumper()
        plugIn()
        val expected = listOf(listOf(PortSensor.LEFT_BUMPER), listOf(PortSensor.LIGHT), listOf(PortSensor.RIGHT_BUMPER))
        assertEquals(expected, workshop.ports)
        assertEquals(Notice.SensorsPluggedIn(listOf("1")), workshop.state.notice)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(300)
        assertTrue(workshop.state.running)
        assertNull(workshop.state.notice, "It asks for this run.")
        assertEquals(emptyList(), workshop.state.shownProgramRun.warnings)
    }

    @Test
    fun `the notice undoes it`() {
        runWithoutLeftBumper()
        plugIn()
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(emptyList(), workshop.ports.first())
        assertNull(workshop.state.notice)
    }

    @Test
    fun `what is changed in the world meanwhile stays when the notice undoes it`() {
        runWithoutLeftBumper()
        plugIn()
        val walls = workshop.project.world.walls.size
        edit(WorldEdit.Put(PaletteItem.WALL.piece(workshop.project.world), Point(60.0, 45.0)))
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(emptyList(), workshop.ports.first())
        assertEquals(walls + 1, workshop.project.world.walls.size)
        edit(WorldEdit.Undo)
        assertEquals(listOf(PortSensor.LEFT_BUMPER), workshop.ports.first(), "The editor can undo the undoing.")
        edit(WorldEdit.Undo)
        assertEquals(walls, workshop.project.world.walls.size)
    }

    @Test
    fun `other changes of the same robot stay as well`() {
        runWithoutLeftBumper()
        plugIn()
        change { withPorts(ports.dropLast(1) + listOf(listOf(PortSensor.TEMPERATURE))) }
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(listOf(emptyList(), listOf(PortSensor.LIGHT), listOf(PortSensor.TEMPERATURE)), workshop.ports)
    }

    @Test
    fun `the notice goes when the world editor undoes it, and Redo there plugs in again`() {
        runWithoutLeftBumper()
        plugIn()
        edit(WorldEdit.Undo)
        assertEquals(emptyList(), workshop.ports.first())
        assertNull(workshop.state.notice)
        edit(WorldEdit.Redo)
        assertEquals(listOf(PortSensor.LEFT_BUMPER), workshop.ports.first())
    }

    @Test
    fun `the notice goes when there is nothing left to take out`() {
        runWithoutLeftBumper()
        plugIn()
        change { withPorts(listOf(listOf(PortSensor.LEFT_ROTATION)) + ports.drop(1)) }
        assertNull(workshop.state.notice)
    }

    @Test
    fun `the notice goes with its world`() {
        runWithoutLeftBumper()
        plugIn()
        workshop.services.editor.changeWorld(BuiltInWorlds.plain, isAnother = true)
        assertNull(workshop.state.notice)
        runWithoutLeftBumper()
        plugIn()
        workshop.services.editor.openProject(workshop.project.copy(world = BuiltInWorlds.plain))
        assertNull(workshop.state.notice)
    }

    @Test
    fun `while the world is being edited, plugging in and undoing are steps of the editor`() {
        runWithoutLeftBumper()
        val run = workshop.state.shownProgramRun
        workshop.handle(WorldEditEvent.EditorOpened)
        workshop.handle(WorldEditEvent.SensorsPluggedIn(run.robot, checkNotNull(run.missingSensors)))
        assertEquals(listOf(PortSensor.LEFT_BUMPER), workshop.ports.first())
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(emptyList(), workshop.ports.first())
        workshop.handle(WorldEditEvent.Edited(WorldEdit.Redo))
        workshop.handle(WorldEditEvent.EditorClosed)
        assertEquals(listOf(PortSensor.LEFT_BUMPER), workshop.ports.first())
        assertTrue(workshop.state.session.robots.first().missingSensors == null)
    }

    @Test
    fun `all sensors that are missing are one remark and one change`() {
        runWith(listOf(emptyList(), listOf(PortSensor.LIGHT), emptyList()), BOTH)
        val run = workshop.state.shownProgramRun
        assertEquals(2, run.warnings.single().sourceLine, "It names the line that feels first.")
        assertContains(run.warnings.single().message, "Touch sensors are missing on ports 1 and 3")
        workshop.handle(WorldEditEvent.SensorsPluggedIn(run.robot, checkNotNull(run.missingSensors)))
        assertEquals(Notice.SensorsPluggedIn(listOf("1", "3")), workshop.state.notice)
        assertEquals(BuiltInWorlds.plain.robots.first().ports, workshop.ports)
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(listOf(emptyList(), listOf(PortSensor.LIGHT), emptyList()), workshop.ports)
    }

    private fun edit(edit: WorldEdit) {
        workshop.handle(WorldEditEvent.EditorOpened)
        workshop.handle(WorldEditEvent.Edited(edit))
        workshop.handle(WorldEditEvent.EditorClosed)
    }

    private fun change(how: RobotPlacement.() -> RobotPlacement) {
        val robot = workshop.project.world.robots.first().how()
        edit(WorldEdit.Change(ElementRef(ElementKind.ROBOT, 0), Element.OfRobot(robot)))
    }

    private companion object {
        const val LEFT = "if left bumper\n  beep\nend\nwait 5 seconds\n"
        const val BOTH = "beep\nif left bumper and not right bumper\n  beep\nend\nwait 5 seconds\n"
    }
}
