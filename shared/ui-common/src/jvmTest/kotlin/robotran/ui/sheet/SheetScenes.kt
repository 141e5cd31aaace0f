package robotran.ui.sheet

import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.toPixelMap
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.messages.BrickMessages
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.simulation.state.LampState
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
import robotran.world.Barrier
import robotran.world.Goal
import robotran.world.GoalCondition.All
import robotran.world.GoalCondition.InOrder
import robotran.world.GoalCondition.Reach
import robotran.world.GoalCondition.StayIn
import robotran.world.GoalCondition.StayOut
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.Paper
import robotran.world.RobotColour
import robotran.world.RobotPlacement
import robotran.world.Shade
import robotran.world.Template
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape

/** Worlds and states for pictures. */
internal object SheetScenes {
    /** One of each kind of element. */
    val everything = World(
        title = "Everything",
        paper = Paper(120.0, 90.0),
        robots = listOf(
            RobotPlacement(Pose(20.0, 20.0, 0.0)),
            RobotPlacement(Pose(90.0, 66.0, 135.0), "red", RobotColour.RED, beacon = 1.0),
        ),
        walls = listOf(
            Wall(Point(2.0, 88.0), Point(118.0, 88.0), 1.0),
            Wall(Point(118.0, 88.0), Point(118.0, 50.0), 1.0),
        ),
        barriers = listOf(
            Barrier(Shape.Rectangle(Point(60.0, 70.0), 14.0, 5.0, 30.0)),
            Barrier(Shape.Circle(Point(38.0, 66.0), 4.0)),
            Barrier(Shape.Polygon(listOf(Point(40.0, 80.0), Point(52.0, 80.0), Point(46.0, 76.0), Point(42.0, 72.0)))),
        ),
        blocks = listOf(
            MovableBlock(Shape.Rectangle(Point(36.0, 30.0), 6.0, 9.0)),
            MovableBlock(Shape.Circle(Point(36.0, 12.0), 3.0)),
            MovableBlock(Shape.Polygon(listOf(Point(45.0, 8.0), Point(54.0, 8.0), Point(45.0, 16.0)))),
        ),
        marks = listOf(
            Mark(
                MarkFigure.Line(
                    listOf(Point(60.0, 10.0), Point(80.0, 10.0), Point(85.0, 25.0), Point(62.0, 28.0)),
                    2.0,
                    closed = true,
                ),
            ),
            Mark(
                MarkFigure.Line(listOf(Point(62.0, 36.0), Point(72.0, 36.0), Point(80.0, 42.0)), 2.5),
                Shade.Colour(0x11, 0x33, 0xaa),
            ),
            Mark(MarkFigure.Area(Shape.Rectangle(Point(98.0, 36.0), 12.0, 8.0, 20.0)), Shade.Colour(0x22, 0x66, 0xcc)),
            Mark(MarkFigure.Area(Shape.Circle(Point(110.0, 24.0), 5.0)), Shade.Colour(0xcc, 0x33, 0x22)),
            Mark(MarkFigure.Area(Shape.Circle(Point(98.0, 22.0), 4.0)), Shade.Grey(0.5)),
            Mark(
                MarkFigure.GreyMap(
                    Point(90.0, 6.0),
                    2.0,
                    listOf("0123456789abcdef", "f.f.f.f.f.f.f.f.", "0000000000000000"),
                ),
            ),
        ),
        lamps = listOf(
            Lamp(Point(12.0, 76.0), brightness = 1.0),
            Lamp(Point(75.0, 82.0), brightness = 1.0, direction = -110.0, cone = 70.0),
            Lamp(Point(112.0, 56.0), on = false),
        ),
        template = Template(
            listOf(
                listOf(Point(10.0, 40.0), Point(30.0, 40.0), Point(30.0, 55.0)),
                listOf(Point(10.0, 45.0), Point(20.0, 55.0)),
            ),
        ),
        goals = listOf(
            Goal(
                InOrder(
                    listOf(
                        Goal(Reach(Shape.Circle(Point(10.0, 58.0), 7.0))),
                        Goal(Reach(Shape.Rectangle(Point(110.0, 75.0), 12.0, 16.0))),
                    ),
                ),
            ),
            Goal(Reach(Shape.Rectangle(Point(52.0, 50.0), 16.0, 12.0, 15.0), who = "red")),
            Goal(All(listOf(Goal(StayOut(Shape.Circle(Point(78.0, 54.0), 6.0)))))),
            Goal(StayIn(Shape.Rectangle(Point(60.0, 45.0), 116.0, 86.0))),
        ),
    )

    /** With moved blocks, drawings of both robots and the first goal met. */
    val everythingLater = state(
        everything,
        poses = listOf(Pose(24.0, 22.0, 30.0), Pose(90.0, 66.0, 135.0)),
        blocks = listOf(Pose(3.0, 1.0, 20.0), Pose(0.0, 0.0, 0.0), Pose(0.0, 2.0, -15.0)),
        strokes = listOf(
            InkStroke(listOf(Point(5.0, 5.0), Point(5.0, 25.0), Point(24.0, 22.0))),
            InkStroke(listOf(Point(110.0, 62.0), Point(100.0, 50.0), Point(90.0, 66.0)), robot = 1),
        ),
        goals = listOf(progress(GoalStatus.PENDING, listOf(progress(GoalStatus.MET), progress(GoalStatus.PENDING)))),
    )

    /** The initial state of a session in [world] by default. */
    fun state(
        world: World,
        poses: List<Pose> = world.robots.map { it.start },
        blocks: List<Pose> = world.blocks.map { Pose(0.0, 0.0, 0.0) },
        lamps: List<LampState> = world.lamps.map { LampState(it.place, it.on) },
        strokes: List<InkStroke> = emptyList(),
        goals: List<GoalProgress> = emptyList(),
    ) = SessionState(
        milliseconds = 0,
        robots = poses.map {
            RobotSnapshot(
                RcxBrick(emptyList(), messages = BrickMessages.of(Language.ENGLISH)).state,
                RobotState(it, 0.0, 0.0, false, false, false),
                0,
                emptyList(),
                0,
            )
        },
        blocks = blocks,
        lamps = lamps,
        ink = if (strokes.isEmpty()) Ink.NONE else Ink(strokes, 0.0),
        goals = goals,
    )

    fun progress(status: GoalStatus, parts: List<GoalProgress> = emptyList()) =
        GoalProgress("A goal.", status, if (status == GoalStatus.MET) 1.0 else 0.0, parts)

    /** An empty world with the elements that [change] adds; a robot is out of the way in a corner. */
    fun with(change: World.() -> World): World =
        World("Test", Paper(96.0, 46.0), listOf(RobotPlacement(Pose(10.0, 10.0, 0.0)))).change()
}

/** A picture with 20 pixels per centimetre of a world of 96 by 46 cm. */
internal fun closeUp(world: World, state: SessionState = SheetScenes.state(world)): ImageBitmap =
    renderSheet(world, state, widthPixels = 2000)

/** The colour at a position in centimetres on a [closeUp]. */
internal fun ImageBitmap.at(x: Double, y: Double): Color =
    toPixelMap(((x + 2) * 20).toInt(), ((48 - y) * 20).toInt(), 1, 1)[0, 0]
