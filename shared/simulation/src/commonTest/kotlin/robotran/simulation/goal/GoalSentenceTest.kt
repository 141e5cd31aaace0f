package robotran.simulation.goal

import kotlinx.coroutines.test.runTest
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
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.RobotPlacement
import robotran.world.TouchKind
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals

class GoalSentenceTest {
    private val garage = rectangle(80.0, 60.0, 100.0, 80.0)
    private val home = Shape.Circle(Point(50.0, 40.0), 9.0)
    private val world = sheet.copy(
        robots = sheet.robots + RobotPlacement(Pose(20.0, 20.0, 0.0), name = "red"),
        blocks = listOf(MovableBlock(rectangle(10.0, 10.0, 14.0, 14.0), name = "box")),
        marks = listOf(
            Mark(MarkFigure.Area(home), name = "home"),
            Mark(
                MarkFigure.Line(listOf(Point(0.0, 0.0), Point(9.0, 9.0), Point(0.0, 9.0)), 2.0, closed = true),
                name = "loop",
            ),
            Mark(MarkFigure.Line(listOf(Point(0.0, 0.0), Point(9.0, 9.0)), 2.0), name = "road"),
        ),
    )

    private suspend fun sentence(goal: Goal) = run(goal, world = world).goal.sentence

    @Test
    fun `every goal is said from its figures`() = runTest {
        val sentences = mapOf(
            Goal(Reach(garage)) to "Drive your robot to the marked area at the top right.",
            Goal(Reach(home, who = "yellow", whole = true, within = 30)) to
                "Drive all of your robot into the area \"home\" within 30 seconds.",
            Goal(Reach(garage, who = "box", stays = true)) to
                "Push the block \"box\" to the marked area at the top right, and let it be there at the end.",
            Goal(Reach(home, who = "red")) to "Drive the robot \"red\" to the area \"home\".",
            Goal(StayOut(garage)) to "Keep your robot out of the marked area at the top right.",
            Goal(StayIn(home, whole = true)) to "Keep every part of your robot in the area \"home\".",
            Goal(NeverTouch()) to "Never touch anything.",
            Goal(NeverTouch(setOf(TouchKind.ROBOTS, TouchKind.WALLS, TouchKind.BARRIERS))) to
                "Never touch a wall, a barrier or another robot.",
            Goal(NeverTouch(setOf(TouchKind.BLOCKS), who = "red")) to "Let the robot \"red\" never touch a block.",
            Goal(DrawTemplate(tolerance = 1.5)) to
                "Trace the drawing: 90 % of it, and not more than 1.5 cm beside it.",
            Goal(InkLength(20.0, null)) to "Draw 20 cm or more.",
            Goal(InkLength(null, 30.5)) to "Do not draw more than 30.5 cm.",
            Goal(InkLength(20.0, 30.0)) to "Draw 20 to 30 cm.",
            Goal(FollowLine("loop")) to "Follow the line \"loop\" once round.",
            Goal(FollowLine("loop", laps = 3.0, within = 60)) to
                "Follow the line \"loop\" 3 times round within 60 seconds.",
            Goal(FollowLine("road")) to "Follow the line \"road\" from one end to the other.",
            Goal(FollowLine("road", laps = 2.0, who = "red")) to
                "Let the robot \"red\" follow the line \"road\" from one end to the other, 2 times.",
            Goal(FollowLine("road", laps = 0.8)) to "Follow the line \"road\" for 80 % of its length.",
            Goal(EndWithin(1)) to "Your program must come to its end within 1 second.",
            Goal(EndWithin(20, who = "red")) to
                "The program of the robot \"red\" must come to its end within 20 seconds.",
            Goal(ShowOnDisplay(" HELLO")) to "Show \"HELLO\" on the display.",
            Goal(ShowOnDisplay("4", stays = true)) to "Show \"4\" on the display, and leave it there at the end.",
            Goal(PlaySound()) to "Play a tone.",
            Goal(PlaySound(3, lowest = 400, highest = 500)) to "Play exactly 3 tones of 400 to 500 hertz.",
            Goal(PlaySound(1)) to "Play exactly one tone.",
            Goal(PlaySound(2, lowest = 440, highest = 440, who = "red")) to
                "Let the robot \"red\" play exactly 2 tones of 440 hertz.",
            Goal(InOrder(listOf(Goal(PlaySound())))) to "Do these one after the other.",
            Goal(All(listOf(Goal(PlaySound())))) to "Do all of these.",
            Goal(AnyOf(listOf(Goal(PlaySound())))) to "Do one of these.",
        )
        for ((goal, expected) in sentences) assertEquals(expected, sentence(goal))
    }

    @Test
    fun `what the author says is said instead`() = runTest {
        assertEquals("Park the car.", sentence(Goal(Reach(garage), says = "Park the car.")))
    }

    @Test
    fun `the only line needs no name`() = runTest {
        val goal = run(Goal(FollowLine("loop")), world = world.copy(marks = world.marks.take(2))).goal
        assertEquals("Follow the line once round.", goal.sentence)
    }

    @Test
    fun `a region is told by the ninth of the paper that it is in`() = runTest {
        val rows = listOf(
            listOf("at the bottom left", "at the bottom", "at the bottom right"),
            listOf("on the left", "in the middle", "on the right"),
            listOf("at the top left", "at the top", "at the top right"),
        )
        rows.flatten().forEachIndexed { number, word ->
            val region = Shape.Circle(Point(17.0 + 33 * (number % 3), 13.0 + 27 * (number / 3)), 5.0)
            assertEquals("Keep your robot in the marked area $word.", sentence(Goal(StayIn(region))))
        }
    }
}
