package robotran.worldediting

import robotran.world.Barrier
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.RobotColour
import robotran.world.RobotPlacement
import robotran.world.Wall
import robotran.world.World
import robotran.world.file.wordFor
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape

/** The elements that an editor offers to add. */
enum class PaletteItem {
    WALL,
    BOX,
    COLUMN,
    CORNERED_BARRIER,
    BLOCK,
    ROUND_BLOCK,
    LINE,
    AREA,
    DOT,
    CORNERED_AREA,
    LAMP,
    TEMPLATE_LINE,
    GOAL_AREA,
    FORBIDDEN_AREA,
    PERMITTED_AREA,
    ROBOT,
}

/** The colour of the next robot: one that no other has, while there is one. */
val World.nextRobotColour: RobotColour
    get() = RobotColour.entries.firstOrNull { colour -> robots.none { it.colour == colour } }
        ?: RobotColour.entries[robots.size % RobotColour.entries.size]

/** A new element near the paper's lower left corner; [WorldEdit.Put] moves it. */
fun PaletteItem.piece(world: World): Element = when (this) {
    PaletteItem.WALL -> Element.OfWall(Wall(Point(0.0, 0.0), Point(30.0, 0.0), thickness = 1.0))
    PaletteItem.BOX -> Element.OfBarrier(Barrier(rectangle(16.0, 10.0)))
    PaletteItem.COLUMN -> Element.OfBarrier(Barrier(circle(5.0)))
    PaletteItem.CORNERED_BARRIER -> Element.OfBarrier(Barrier(triangle(16.0)))
    PaletteItem.BLOCK -> Element.OfBlock(MovableBlock(rectangle(8.0, 8.0)))
    PaletteItem.ROUND_BLOCK -> Element.OfBlock(MovableBlock(circle(4.0)))

    PaletteItem.LINE -> Element.OfMark(
        Mark(MarkFigure.Line(listOf(Point(0.0, 0.0), Point(15.0, 10.0), Point(30.0, 0.0)), LINE_WIDTH)),
    )

    PaletteItem.AREA -> Element.OfMark(Mark(MarkFigure.Area(rectangle(20.0, 14.0))))
    PaletteItem.DOT -> Element.OfMark(Mark(MarkFigure.Area(circle(6.0))))
    PaletteItem.CORNERED_AREA -> Element.OfMark(Mark(MarkFigure.Area(triangle(20.0))))
    PaletteItem.LAMP -> Element.OfLamp(Lamp(Point(0.0, 0.0)))
    PaletteItem.TEMPLATE_LINE -> Element.OfStroke(listOf(Point(0.0, 0.0), Point(30.0, 0.0)))
    PaletteItem.GOAL_AREA -> Element.OfGoal(Goal(GoalCondition.Reach(rectangle(20.0, 20.0))))
    PaletteItem.FORBIDDEN_AREA -> Element.OfGoal(Goal(GoalCondition.StayOut(rectangle(20.0, 20.0))))
    PaletteItem.PERMITTED_AREA -> Element.OfGoal(Goal(GoalCondition.StayIn(rectangle(60.0, 40.0))))

    PaletteItem.ROBOT -> world.nextRobotColour.let {
        Element.OfRobot(RobotPlacement(Pose(0.0, 0.0, 0.0), wordFor(it), it))
    }
}

private fun rectangle(width: Double, height: Double) = Shape.Rectangle(Point(width / 2, height / 2), width, height)

private fun circle(radius: Double) = Shape.Circle(Point(radius, radius), radius)

private fun triangle(side: Double) = Shape.Polygon(listOf(Point(0.0, 0.0), Point(side, 0.0), Point(side / 2, side)))
