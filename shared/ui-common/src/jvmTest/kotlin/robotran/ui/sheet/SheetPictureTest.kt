package robotran.ui.sheet

import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.toArgb
import androidx.compose.ui.graphics.toPixelMap
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.messages.BrickMessages
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
import robotran.ui.pictures.sheetPng
import robotran.world.ReadyRobots
import robotran.world.RobotColour
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import java.io.ByteArrayInputStream
import javax.imageio.ImageIO
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class SheetPictureTest {
    private val world = BuiltInWorlds.plain
    private val plan = RobotPlan(ReadyRobots.RCX_PENBOT)

    @Test
    fun `ink is where the pen went, as wide as the pen`() {
        val picture = picture(ink = listOf(Point(60.0, 60.0), Point(80.0, 60.0)))
        assertEquals(SheetColours.INK, picture.at(70.0, 60.0))
        assertEquals(SheetColours.INK, picture.at(70.0, 60.1))
        assertEquals(SheetColours.LIGHT.paper, picture.at(70.0, 60.4))
        assertEquals(SheetColours.LIGHT.paper, picture.at(81.0, 60.0))
    }

    @Test
    fun `a pen that is put down and lifted leaves a dot`() {
        assertEquals(SheetColours.INK, picture(ink = listOf(Point(60.0, 60.0))).at(60.0, 60.0))
    }

    @Test
    fun `the paper lies on the desk inside its walls`() {
        val picture = picture()
        assertEquals(SheetColours.LIGHT.paper, picture.at(1.0, 1.0))
        assertEquals(SheetColours.LIGHT.desk, picture.at(-1.6, 40.0))
        assertNotEquals(SheetColours.LIGHT.desk, picture.at(-0.5, 40.0))
        assertNotEquals(SheetColours.LIGHT.paper, picture.at(100.5, 40.0))
    }

    @Test
    fun `the tip of the pen is red while it is down`() {
        assertEquals(RobotColours.PEN_TIP_DOWN, picture(penDown = true).at(40.0, 30.0))
        assertEquals(RobotColours.PEN_TIP_UP, picture(penDown = false).at(40.0, 30.0))
    }

    @Test
    fun `the robot looks where it is headed`() {
        val brick = plan.brick.box.left + 0.4
        assertEquals(RobotColours.brick(RobotColour.YELLOW), picture(heading = 0.0).at(40.0 + brick, 30.0))
        assertEquals(RobotColours.brick(RobotColour.YELLOW), picture(heading = 90.0).at(40.0, 30.0 + brick))
        assertEquals(RobotColours.brick(RobotColour.YELLOW), picture(heading = 180.0).at(40.0 - brick, 30.0))
    }

    @Test
    fun `a bumper that is hit moves in`() {
        val front = plan.bumpers.first().bar(0f).right - 0.25
        // Where it was, the paper is bare but for the robot's shadow.
        assertEquals(RobotColours.BUMPER, picture(leftBumper = false).at(40.0 + front, 33.0))
        assertTrue(picture(leftBumper = true).at(40.0 + front, 33.0).red > RobotColours.BUMPER.red)
        assertEquals(RobotColours.BUMPER, picture(leftBumper = true).at(40.0 + front, 27.0))
    }

    @Test
    fun `the file is a PNG of the width asked for`() {
        val image = ImageIO.read(ByteArrayInputStream(sheetPng(world, state(), widthPixels = 520)))
        assertEquals(520, image.width)
        assertEquals(420, image.height)
        assertEquals(SheetColours.LIGHT.paper.toArgb(), image.getRGB(260, 40))
    }

    @Test
    fun `a picture without any size is refused`() {
        assertFailsWith<IllegalArgumentException> { renderSheet(world, state(), widthPixels = 0) }
    }

    private fun picture(
        ink: List<Point> = emptyList(),
        penDown: Boolean = false,
        heading: Double = 0.0,
        leftBumper: Boolean = false,
    ): ImageBitmap = renderSheet(world, state(ink, penDown, heading, leftBumper), widthPixels = 2080)

    /** The colour at a position in centimetres: 2080 pixels are 20 per centimetre, with 2 cm of desk on each side. */
    private fun ImageBitmap.at(x: Double, y: Double): Color =
        toPixelMap(((x + 2) * 20).toInt(), ((82 - y) * 20).toInt(), 1, 1)[0, 0]

    private fun state(
        ink: List<Point> = emptyList(),
        penDown: Boolean = false,
        heading: Double = 0.0,
        leftBumper: Boolean = false,
    ) = SessionState(
        milliseconds = 0,
        robots = listOf(
            RobotSnapshot(
                brick = RcxBrick(emptyList(), messages = BrickMessages.of(Language.ENGLISH)).state,
                robot = RobotState(Pose(40.0, 30.0, heading), 0.0, 0.0, penDown, leftBumper, false),
                bumps = 0,
                warnings = emptyList(),
                romCalls = 0,
            ),
        ),
        blocks = emptyList(),
        lamps = emptyList(),
        ink = if (ink.isEmpty()) Ink.NONE else Ink(listOf(InkStroke(ink)), 0.0),
        goals = emptyList(),
    )
}
