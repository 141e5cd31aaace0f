package robotran.simulation.goal

import kotlinx.coroutines.test.runTest
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.Reach
import robotran.world.GoalCondition.StayIn
import robotran.world.GoalCondition.StayOut
import robotran.world.MovableBlock
import robotran.world.RobotPlacement
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertSame

class PlaceGoalTest {
    private val garage = rectangle(80.0, 30.0, 100.0, 50.0)
    private val box = MovableBlock(rectangle(20.0, 20.0, 26.0, 24.0), name = "box")
    private val red = RobotPlacement(Pose(20.0, 20.0, 0.0), name = "red")

    @Test
    fun `a region is reached when the pen is in it and stays reached`() = runTest {
        val run = run(Goal(Reach(garage)))
        run.robotAt(50.0, 40.0)
        assertEquals(GoalStatus.PENDING, run.status)
        assertEquals(0.0, run.goal.progress)
        run.robotAt(65.0, 40.0)
        assertEquals(0.5, run.goal.progress)
        run.robotAt(80.0, 40.0)
        assertEquals(GoalStatus.MET, run.status)
        run.robotAt(50.0, 40.0)
        run.finish()
        assertEquals(GoalStatus.MET, run.status)
        assertEquals(1.0, run.goal.progress)
    }

    @Test
    fun `the whole robot is there only when its bumpers and its back are`() = runTest {
        val run = run(Goal(Reach(garage, whole = true)))
        for ((x, status) in listOf(84.9 to GoalStatus.PENDING, 91.0 to GoalStatus.PENDING, 85.1 to GoalStatus.MET)) {
            run.robotAt(x, 40.0)
            assertEquals(status, run.status, "at $x")
        }
        val turned = run(Goal(Reach(rectangle(80.0, 30.0, 94.3, 50.0), whole = true)))
        turned.robotAt(87.15, 35.1, heading = 90.0)
        assertEquals(GoalStatus.MET, turned.status)
    }

    @Test
    fun `what is whole in a circle is whole`() = runTest {
        val run = run(Goal(Reach(Shape.Circle(Point(50.0, 40.0), 12.0), whole = true)))
        run.robotAt(51.0, 40.0)
        assertEquals(GoalStatus.PENDING, run.status)
        run.robotAt(48.0, 40.0)
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `a dented region does not hold what lies over its dent`() = runTest {
        val corners = listOf(
            0.0 to 0.0,
            60.0 to 0.0,
            60.0 to 60.0,
            31.0 to 60.0,
            30.0 to 20.0,
            29.0 to 60.0,
            0.0 to 60.0,
        )
        val dented = Shape.Polygon(corners.map { Point(it.first, it.second) })
        val run = run(Goal(Reach(dented, whole = true)))
        run.robotAt(28.0, 40.0)
        assertEquals(GoalStatus.PENDING, run.status)
        run.robotAt(28.0, 10.0)
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `a region that is reached too late is not reached any more`() = runTest {
        val run = run(Goal(Reach(garage, within = 5)))
        run.until(5.0)
        assertEquals(GoalStatus.PENDING, run.status)
        run.robotAt(90.0, 40.0)
        assertEquals(GoalStatus.FAILED, run.status)
        val inTime = run(Goal(Reach(garage, within = 5)))
        inTime.until(4.99)
        inTime.robotAt(90.0, 40.0)
        inTime.until(9.0)
        assertEquals(GoalStatus.MET, inTime.status)
    }

    @Test
    fun `who has to stay must be there at the end`() = runTest {
        val run = run(Goal(Reach(garage, stays = true)))
        run.robotAt(90.0, 40.0)
        assertEquals(GoalStatus.PENDING to true, run.status to run.goal.holds, "it may still drive on")
        run.robotAt(70.0, 40.0)
        assertEquals(GoalStatus.PENDING to false, run.status to run.goal.holds)
        run.finish()
        assertEquals(GoalStatus.FAILED, run.status)
        val back = run(Goal(Reach(garage, within = 2, stays = true)))
        back.robotAt(90.0, 40.0)
        back.robotAt(70.0, 40.0)
        back.robotAt(90.0, 40.0)
        back.until(3.0)
        back.finish()
        assertEquals(GoalStatus.MET, back.status)
        val late = run(Goal(Reach(garage, within = 2, stays = true)))
        late.robotAt(90.0, 40.0)
        late.until(3.0)
        late.robotAt(70.0, 40.0)
        assertEquals(GoalStatus.FAILED, late.status)
    }

    @Test
    fun `a block is where it has been pushed to`() = runTest {
        val goals = arrayOf(Goal(Reach(garage, who = "box")), Goal(Reach(garage, who = "box", whole = true)))
        val run = run(*goals, world = sheet.copy(blocks = listOf(box)))
        run.robotAt(90.0, 40.0)
        assertEquals(listOf(GoalStatus.PENDING, GoalStatus.PENDING), run.goals.map { it.status })
        run.blockAt(58.0, 15.0)
        assertEquals(listOf(GoalStatus.MET, GoalStatus.PENDING), run.goals.map { it.status })
        // Upright, it is only 4 cm wide.
        run.blockAt(59.1, 15.0, heading = 90.0)
        assertEquals(listOf(GoalStatus.MET, GoalStatus.MET), run.goals.map { it.status })
    }

    @Test
    fun `a triangle turns about the middle of its area`() = runTest {
        val triangle =
            MovableBlock(Shape.Polygon(listOf(Point(0.0, 0.0), Point(9.0, 0.0), Point(0.0, 9.0))), name = "wedge")
        val run =
            run(
                Goal(Reach(rectangle(2.9, 2.9, 3.1, 3.1), who = "wedge")),
                world = sheet.copy(blocks = listOf(triangle)),
            )
        run.blockAt(0.0, 0.0, heading = 77.0)
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `another robot is judged by its name`() = runTest {
        val run = run(Goal(Reach(garage, who = "red")), world = sheet.copy(robots = sheet.robots + red))
        run.robotAt(90.0, 40.0)
        assertEquals(GoalStatus.PENDING, run.status)
        run.robotAt(90.0, 40.0, number = 1)
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `nobody cannot reach anything`() = runTest {
        val run = run(Goal(Reach(garage, who = "nobody")), Goal(NeverTouch(who = "nobody")))
        run.robotAt(90.0, 40.0)
        run.finish()
        assertEquals(listOf(GoalStatus.FAILED, GoalStatus.FAILED), run.goals.map { it.status })
    }

    @Test
    fun `a forbidden region is entered by the pen or, as a whole, by any part`() = runTest {
        val run = run(Goal(StayOut(garage)), Goal(StayOut(garage, whole = true)))
        run.robotAt(70.0, 40.0)
        assertEquals(listOf(GoalStatus.PENDING, GoalStatus.PENDING), run.goals.map { it.status })
        run.robotAt(71.0, 40.0)
        assertEquals(listOf(GoalStatus.PENDING, GoalStatus.FAILED), run.goals.map { it.status })
        run.finish()
        assertEquals(listOf(GoalStatus.MET, GoalStatus.FAILED), run.goals.map { it.status })
    }

    @Test
    fun `a forbidden region is entered even where no corner lies in the other`() = runTest {
        val strip = run(Goal(StayOut(rectangle(0.0, 43.0, 100.0, 43.5), whole = true)))
        strip.robotAt(50.0, 40.0)
        assertEquals(GoalStatus.FAILED, strip.status)
        val dot = run(Goal(StayOut(Shape.Circle(Point(52.0, 40.0), 0.5), whole = true)))
        dot.robotAt(50.0, 40.0)
        assertEquals(GoalStatus.FAILED, dot.status)
    }

    @Test
    fun `a region to stay in is left by the pen or, as a whole, by any part`() = runTest {
        val table = rectangle(0.0, 0.0, 100.0, 80.0)
        val run = run(Goal(StayIn(table)), Goal(StayIn(table, whole = true)))
        run.robotAt(90.0, 40.0)
        assertEquals(listOf(GoalStatus.PENDING, GoalStatus.PENDING), run.goals.map { it.status })
        run.robotAt(91.0, 40.0)
        assertEquals(listOf(GoalStatus.PENDING, GoalStatus.FAILED), run.goals.map { it.status })
        run.robotAt(100.1, 40.0)
        assertEquals(listOf(GoalStatus.FAILED, GoalStatus.FAILED), run.goals.map { it.status })
    }

    @Test
    fun `the list is the same one as long as nothing changes`() = runTest {
        val run = run(Goal(Reach(garage)), Goal(StayIn(garage)))
        run.robotAt(90.0, 40.0)
        val before = run.goals
        run.robotAt(91.0, 40.0)
        assertSame(before, run.goals)
    }
}
