package robotran.ui.sheet

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.asSkiaBitmap
import androidx.compose.ui.unit.IntSize
import org.jetbrains.skia.Image
import robotran.brick.controls.MotorPort
import robotran.brick.sensors.SensorKind
import robotran.nxt.state.NxtState
import robotran.simulation.state.SessionState
import robotran.ui.brick.nxt.NxtScenes
import robotran.ui.golden.GoldenPicture
import robotran.ui.pictures.labelsWith
import robotran.ui.pictures.pictureFonts
import robotran.ui.sheet3d.renderSpace
import robotran.uikit.*
import robotran.workshop.state.SheetLayer
import robotran.world.BumperPart
import robotran.world.Facing
import robotran.world.Paper
import robotran.world.ReadyRobots
import robotran.world.RobotColour
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.SensorPart
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.test.Test

/** Compares pictures of all kinds of robots on the sheet with reviewed ones. */
class RobotsPictureTest {
    private val wedge: RobotDescription = ReadyRobots.RCX_PENBOT.copy(
        title = "Wedge",
        chassis = ReadyRobots.RCX_PENBOT.chassis.copy(
            outline = listOf(Point(-6.0, -4.0), Point(6.0, -4.0), Point(10.0, 0.0), Point(6.0, 4.0), Point(-6.0, 4.0)),
        ),
        pen = null,
        parts = listOf(BumperPart(1, Point(8.8, 3.0), width = 5.0, direction = 45.0)),
    )
    private val robots = listOf(
        RobotPlacement(Pose(20.0, 70.0, 0.0), "yellow", RobotColour.YELLOW, ReadyRobots.NXT_PENBOT),
        RobotPlacement(Pose(65.0, 70.0, 20.0), "red", RobotColour.RED, ReadyRobots.LINE_FOLLOWER),
        RobotPlacement(Pose(104.0, 70.0, 0.0), "blue", RobotColour.BLUE, ReadyRobots.SUMO),
        RobotPlacement(Pose(20.0, 25.0, 0.0), "green", RobotColour.GREEN, ReadyRobots.BOTH_SIDES),
        RobotPlacement(Pose(65.0, 25.0, 0.0), "orange", RobotColour.ORANGE, ReadyRobots.RCX_PENBOT),
        RobotPlacement(Pose(104.0, 25.0, 60.0), "white", RobotColour.WHITE, wedge),
    )
    private val world = World(
        title = "Robots",
        paper = Paper(125.0, 95.0),
        robots = robots,
        walls = listOf(Wall(Point(40.0, 55.0), Point(40.0, 93.0), 1.0)),
    )

    @Test
    fun `all robots look as they did on the sheet`() {
        for ((name, colours) in listOf("light" to RobotranColours.LIGHT, "dark" to RobotranColours.DARK)) {
            GoldenPicture.check("robots-$name", picture(SheetColours.of(colours), SheetLayer.DEFAULT))
            GoldenPicture.check("robots-sights-$name", picture(SheetColours.of(colours), setOf(SheetLayer.SENSORS)))
        }
    }

    private val state: SessionState = SheetScenes.state(world).let { resting ->
        resting.copy(
            robots = resting.robots.zip(robots) { snapshot, place ->
                val isNxt = place.description.brick == NxtScenes.menu.kind
                val brick = if (isNxt) hearing(place.description) else snapshot.brick
                snapshot.copy(brick = brick, robot = snapshot.robot.copy(pressed = if (isNxt) setOf(0) else emptySet()))
            },
        )
    }

    /** The state of an NXT whose ultrasonic sensors hear the wall and the other robots. */
    private fun hearing(robot: RobotDescription): NxtState = NxtScenes.running.let { state ->
        val sonars = robot.parts.filter { it.kind == SensorKind.ULTRASONIC }.map { it.port }
        state.copy(
            sensorPorts = state.sensorPorts.map {
                it.copy(distance = if (it.port in sonars) HEARD.getValue(checkNotNull(robot.base))[it.port] else null)
            },
        )
    }

    @Test
    fun `all robots look as they did in perspective`() {
        for ((name, turn, tilt) in listOf(Triple("left", 60.0, 40.0), Triple("front", 200.0, 30.0))) {
            val seen = renderSpace(world, state, IntSize(WIDTH, 1_000)) {
                it.around(world.paper, Point(62.0, 47.0), turn, tilt, 1.1)
            }
            GoldenPicture.check("robots-space-$name", image(seen))
        }
    }

    @Test
    fun `a turret with its sensor looks where its motor has turned it`() {
        val sonar = SensorPart(4, SensorKind.ULTRASONIC, Point(0.0, 0.0), 10.0, Facing.Ahead(0.0), MotorPort.B)
        val robot = ReadyRobots.NXT_PENBOT.copy(title = "Radar", pen = null, parts = listOf(sonar), base = null)
        val place = RobotPlacement(Pose(30.0, 20.0, 0.0), "yellow", RobotColour.YELLOW, robot)
        val room = World("Turret", Paper(60.0, 50.0), listOf(place))
        val turned = SheetScenes.state(room).let { resting ->
            val brick = NxtScenes.running.let { state ->
                state.copy(sensorPorts = state.sensorPorts.map { it.copy(distance = if (it.port == 4) 20 else null) })
            }
            val snapshot = resting.robots.single()
            resting.copy(robots = listOf(snapshot.copy(brick = brick, robot = snapshot.robot.copy(turret = 70.0))))
        }
        val colours = SheetColours.of(RobotranColours.LIGHT)
        val layers = SheetLayer.DEFAULT + SheetLayer.SENSORS
        GoldenPicture.check("robots-turret", picture(room, turned, colours, layers))
        val seen =
            renderSpace(room, turned, IntSize(WIDTH, 1_000)) {
                it.around(room.paper, Point(30.0, 20.0), 200.0, 40.0, 1.5)
            }
        GoldenPicture.check("robots-turret-space", image(seen))
    }

    private fun picture(colours: SheetColours, shown: Set<SheetLayer>) = picture(world, state, colours, shown)

    private fun picture(world: World, state: SessionState, colours: SheetColours, shown: Set<SheetLayer>): Image =
        image(
            renderOn(world, WIDTH, density = 1f) {
                drawSheet(it, state, colours, labelsWith(checkNotNull(pictureFonts())), shown)
            },
        )

    private fun image(bitmap: ImageBitmap): Image = Image.makeFromBitmap(bitmap.asSkiaBitmap())

    private companion object {
        const val WIDTH = 1_600

        /** By the robot and the port. */
        val HEARD = mapOf(
            "nxt-penbot" to mapOf(4 to 11),
            "sumo" to mapOf(4 to 255),
            "both-sides" to mapOf(1 to 33, 4 to 255),
            "line-follower" to emptyMap(),
        )
    }
}
