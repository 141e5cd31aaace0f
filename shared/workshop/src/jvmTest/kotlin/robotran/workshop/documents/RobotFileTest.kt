package robotran.workshop.documents

import kotlinx.coroutines.runBlocking
import robotran.documents.OpenFilesError
import robotran.robotediting.RobotEdit
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.Wall
import robotran.world.file.BuiltInWorlds
import robotran.world.file.writeRobot
import robotran.world.file.writeWorld
import robotran.world.geometry.Point
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Opens robots from files. */
class RobotFileTest {
    private val machine = Machine()
    private val windows = mutableListOf(machine.window())
    private val workshop: Workshop get() = windows.last()

    @AfterTest
    fun close() = windows.forEach(Workshop::close)

    private val robots: List<RobotPlacement> get() = workshop.project.world.robots
    private val robot: RobotDescription get() = robots.first().description

    private fun file(robot: RobotDescription = ReadyRobots.SUMO, name: String = "sumo.robot.json") =
        OpenedFile(name, writeRobot(robot).encodeToByteArray(), "/home/$name")

    private fun bring(vararg files: OpenedFile) = workshop.handle(DocumentEvent.FilesBrought(files.toList()))

    @Test
    fun `a misspelt field is told in the notice, which still brings the robot back`() {
        val before = robot
        val text = """{"format": "robotran-robot", "version": 1, "title": "Wide", "wheels": {"trak": 12}}"""
        bring(OpenedFile("wide.robot.json", text.encodeToByteArray(), "/home/wide.robot.json"))
        val notice = assertIs<Notice.WithWarnings>(workshop.state.notice)
        assertIs<Notice.RobotReplaced>(notice.notice)
        assertTrue("wide.robot.json: Line 1: wheels.trak is not known" in notice.warnings.single(), "$notice")
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(before, robot)
    }

    @Test
    fun `a program in an old encoding or with another name is opened with a remark`() {
        bring(OpenedFile("Karl.robo.txt", "beep // f\u00FCr\n".map { it.code.toByte() }.toByteArray(), null))
        assertEquals("beep // f\u00FCr\n", workshop.state.programText)
        val notice = assertIs<Notice.WithWarnings>(workshop.state.notice)
        assertEquals(
            listOf(
                "Karl.robo.txt is in Windows-1252, not in UTF-8. It was read all the same.",
                "Karl.robo.txt was read as Karl.robo.",
            ),
            notice.warnings,
        )
    }

    @Test
    fun `a robot that is opened takes the place of the robot, and the notice brings that back`() {
        workshop.write("forward 7")
        val before = workshop.state.world
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        machine.files.chosen = listOf(file())
        workshop.handle(DocumentEvent.OpenRequested)
        assertEquals(ReadyRobots.SUMO, robot)
        assertEquals(before.start, workshop.state.world.start)
        assertEquals("forward 7", workshop.state.programText)
        assertEquals("My first work", workshop.state.document.name)
        assertEquals(Pane.WORLD, workshop.state.pane)
        assertEquals(Notice.RobotReplaced("yellow", ReadyRobots.SUMO), workshop.state.notice)
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(before, workshop.state.world)
        assertNull(workshop.state.notice)
    }

    @Test
    fun `a robot that was built is kept in the file, and the work keeps it`() {
        val built = ReadyRobots.BOTH_SIDES.copy(title = "Owl")
        windows += machine.window(OpenRequest.OfFiles(listOf(file(built, "owl.robot.json"))))
        assertEquals(built, robot)
        runBlocking { workshop.closeDocument() }
        windows += machine.window()
        assertEquals(built, robot)
    }

    @Test
    fun `the change is one step of the world editor`() {
        bring(file())
        workshop.handle(WorldEditEvent.EditorOpened)
        workshop.handle(WorldEditEvent.Edited(WorldEdit.Undo))
        workshop.handle(WorldEditEvent.EditorClosed)
        assertEquals(ReadyRobots.RCX_PENBOT, robot)
        assertNull(workshop.state.notice)
    }

    @Test
    fun `in the world editor it takes the place of the robot that is chosen`() {
        val world = workshop.state.world
        val second = RobotPlacement(world.start.copy(y = world.start.y + 30), "blue")
        workshop.services.editor.changeWorld(world.copy(robots = world.robots + second))
        workshop.handle(WorldEditEvent.EditorOpened)
        workshop.handle(WorldEditEvent.Edited(WorldEdit.Select(ElementRef(ElementKind.ROBOT, 1))))
        bring(file())
        assertEquals(listOf(ReadyRobots.RCX_PENBOT, ReadyRobots.SUMO), robots.map { it.description })
        workshop.handle(WorldEditEvent.Edited(WorldEdit.Undo))
        assertEquals(listOf(ReadyRobots.RCX_PENBOT, ReadyRobots.RCX_PENBOT), robots.map { it.description })
    }

    @Test
    fun `in the workbench it is built there, and undo brings the other one back`() {
        workshop.handle(RobotEditEvent.BenchOpened())
        bring(file())
        assertEquals(ReadyRobots.SUMO, assertNotNull(workshop.state.robotEdit).editing.robot)
        workshop.handle(RobotEditEvent.Edited(RobotEdit.Undo))
        assertEquals(ReadyRobots.RCX_PENBOT, robot)
    }

    @Test
    fun `with a world it is the robot of that world`() {
        val corner = BuiltInWorlds.plain.copy(title = "Corner")
        bring(OpenedFile("corner.world.json", writeWorld(corner).encodeToByteArray()), file())
        assertEquals("Corner", workshop.state.world.title)
        assertEquals(ReadyRobots.SUMO, robot)
    }

    @Test
    fun `a robot that has no room is shown in the world editor, and nothing is lost`() {
        val start = workshop.state.world.start
        val wall = Wall(Point(start.x - 5, start.y + 8.6), Point(start.x + 5, start.y + 8.6), 1.0)
        workshop.services.editor.changeWorld(workshop.state.world.copy(walls = listOf(wall)))
        val before = workshop.state.world
        bring(file())
        val editor = assertNotNull(workshop.state.worldEdit)
        assertTrue(editor.hasFailedToClose && editor.editing.errors.isNotEmpty())
        assertEquals(ReadyRobots.SUMO, editor.world.robots.first().description)
        assertEquals(before, workshop.project.world)
        workshop.handle(WorldEditEvent.Edited(WorldEdit.Undo))
        workshop.handle(WorldEditEvent.EditorClosed)
        assertNull(workshop.state.worldEdit)
        assertEquals(before, workshop.state.world)
    }

    @Test
    fun `a file that is no robot is told in a sentence, and nothing is lost`() {
        workshop.write("forward 7")
        val before = workshop.project
        val sumo = writeRobot(ReadyRobots.SUMO)
        for (text in listOf(
            "",
            "{}",
            "[".repeat(50_000),
            sumo.dropLast(3),
            sumo.replace("\"version\": 1", "\"version\": 9"),
        )) {
            bring(OpenedFile("sumo.robot.json", text.encodeToByteArray()))
            val error = assertIs<DocumentDialog.Rejected>(workshop.state.document.dialog).error
            assertTrue(assertIs<OpenFilesError.InFile>(error).message.isNotBlank())
            workshop.handle(DocumentEvent.DialogClosed)
            assertEquals(before, workshop.project)
        }
        bring(file(), file(name = "b.robot.json"))
        assertEquals(
            OpenFilesError.SeveralRobots,
            assertIs<DocumentDialog.Rejected>(workshop.state.document.dialog).error,
        )
        assertEquals(before, workshop.project)
    }
}
