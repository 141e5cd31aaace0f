package robotran.world.file

import robotran.world.Barrier
import robotran.world.Goal
import robotran.world.GoalCondition.All
import robotran.world.GoalCondition.AnyOf
import robotran.world.GoalCondition.DrawTemplate
import robotran.world.GoalCondition.EndWithin
import robotran.world.GoalCondition.FollowLine
import robotran.world.GoalCondition.InOrder
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.PlaySound
import robotran.world.GoalCondition.Reach
import robotran.world.GoalCondition.ShowOnDisplay
import robotran.world.GoalCondition.StayIn
import robotran.world.GoalCondition.StayOut
import robotran.world.Lamp
import robotran.world.LightFacing
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.Paper
import robotran.world.PortSensor
import robotran.world.ReadyRobots
import robotran.world.RobotColour
import robotran.world.RobotPlacement
import robotran.world.Shade
import robotran.world.Template
import robotran.world.TouchKind
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class ReadWorldTest {
    private val full = loaded(FULL_WORLD)

    @Test
    fun `the plain sheet has four walls and a start for a square in its middle`() {
        val world = BuiltInWorlds.plain
        assertEquals("Plain sheet", world.title)
        assertEquals(Paper(100.0, 80.0), world.paper)
        assertEquals(4, world.walls.size)
        assertEquals(Wall(Point(-0.5, -0.5), Point(100.5, -0.5), 1.0), world.walls.first())
        assertEquals(Pose(40.0, 30.0, 0.0), world.start)
        assertEquals(1, world.seed)
    }

    @Test
    fun `every world that comes with Robotran can be read`() {
        BuiltInWorlds.texts.values.forEach(::loaded)
    }

    @Test
    fun `every example of the page on world files can be read`() {
        assertTrue(documentedWorlds.isNotEmpty())
        documentedWorlds.values.forEach(::loaded)
    }

    @Test
    fun `robots are read with all they have`() {
        val ports = listOf(listOf(PortSensor.LEFT_BUMPER), listOf(PortSensor.LIGHT, PortSensor.TOUCH), emptyList())
        val program = "repeat forever\n\tforward 5\nend"
        assertEquals(
            listOf(
                RobotPlacement(
                    Pose(40.0, 30.0, -90.0),
                    "ann",
                    RobotColour.BLUE,
                    ReadyRobots.penbotWith(ports),
                    LightFacing.FORWARD,
                    0.5,
                    program,
                ),
                RobotPlacement(Pose(80.0, 30.0, 0.0), "bob", RobotColour.RED),
                RobotPlacement(Pose(120.0, 30.0, 0.0), "carl", description = ReadyRobots.LINE_FOLLOWER),
                RobotPlacement(Pose(180.0, 50.0, 0.0), "dora", description = loadedRobot(FULL_ROBOT)),
            ),
            full.robots,
        )
    }

    @Test
    fun `what stands and lies on the paper is read`() {
        assertEquals(listOf(Wall(Point(0.0, 90.0), Point(120.0, 90.0), 1.5)), full.walls)
        assertEquals(
            listOf(
                Barrier(Shape.Rectangle(Point(10.0, 60.0), 5.0, 4.0, 30.0), "box"),
                Barrier(Shape.Circle(Point(20.0, 80.0), 3.0)),
                Barrier(Shape.Polygon(listOf(Point(100.0, 60.0), Point(110.0, 60.0), Point(105.0, 70.0)))),
            ),
            full.barriers,
        )
        assertEquals(listOf(MovableBlock(Shape.Circle(Point(150.0, 20.0), 3.0), 0.2, 0.5, "brick")), full.blocks)
        assertEquals(
            listOf(
                Mark(
                    MarkFigure.Line(listOf(Point(10.0, 10.0), Point(30.0, 10.0), Point(30.0, 50.0)), 2.0, true),
                    Shade.Grey(0.1),
                    "loop",
                ),
                Mark(MarkFigure.Area(Shape.Rectangle(Point(150.0, 50.0), 10.0, 10.0)), Shade.Colour(0x11, 0x33, 0xaa)),
                Mark(MarkFigure.GreyMap(Point(1.0, 1.0), 1.0, listOf("0f.", ".8f"))),
            ),
            full.marks,
        )
        assertEquals(listOf(Lamp(Point(1.0, 2.0), 2.0, 90.0, 60.0, false, "window", infrared = true)), full.lamps)
        assertEquals(
            Template(
                listOf(
                    listOf(Point(0.0, 0.0), Point(10.0, 0.0)),
                    listOf(Point(0.0, 5.0), Point(10.0, 5.0), Point(12.0, 7.0)),
                ),
            ),
            full.template,
        )
    }

    @Test
    fun `goals of all kinds are read`() {
        val expected = listOf(
            Goal(Reach(Shape.Circle(Point(5.0, 5.0), 4.0), "brick", whole = true, within = 30, stays = true)),
            Goal(
                StayOut(Shape.Polygon(listOf(Point(0.0, 0.0), Point(1.0, 0.0), Point(1.0, 1.0))), "ann", whole = true),
            ),
            Goal(StayIn(Shape.Rectangle(Point(0.0, 0.0), 9.0, 9.0)), says = "Stay at home."),
            Goal(NeverTouch(setOf(TouchKind.WALLS, TouchKind.ROBOTS), "bob")),
            Goal(DrawTemplate(2.0, 0.8, 0.3)),
            Goal(InOrder(listOf(Goal(InkLength(10.0, 20.0)), Goal(FollowLine("loop", 2.5, 3.0, "ann", 50))))),
            Goal(All(listOf(Goal(EndWithin(20, "ann"))))),
            Goal(AnyOf(listOf(Goal(ShowOnDisplay("HELLO", "bob")), Goal(PlaySound(3, 400, 500, "bob"))))),
        )
        assertEquals(expected, full.goals)
    }

    @Test
    fun `settings are read`() {
        assertEquals("Try all of it.", full.task)
        assertEquals(0.5, full.ambientLight)
        assertEquals(25.0, full.temperature)
        assertEquals(90, full.timeLimit)
        assertEquals(0.3, full.realism)
        assertEquals(7, full.seed)
    }

    @Test
    fun `what a file leaves out is as it usually is`() {
        val min = """{"format": "robotran-world", "version": 2, "title": "T", "paper": {"width": 50, "height": 50},
            "robots": [{"start": {"x": 20, "y": 20, "heading": 0}}]}"""
        assertEquals(World("T", Paper(50.0, 50.0), listOf(RobotPlacement(Pose(20.0, 20.0, 0.0)))), loaded(min))
    }

    @Test
    fun `a heading is brought into half a turn to either side`() {
        val heading = { written: String ->
            loaded(FULL_WORLD.replaceFirst("\"heading\": 270", "\"heading\": $written")).start.heading
        }
        assertEquals(-90.0, heading("270"))
        assertEquals(180.0, heading("-180"))
        assertEquals(0.0, heading("-360"))
        assertEquals(-89.9, heading("270.1"))
    }
}
