package robotran.workshop.measuring

import kotlinx.coroutines.runBlocking
import robotran.projects.Project
import robotran.simulation.physics.loadPhysicsEngine
import robotran.workshop.Workshop
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SheetEvent
import robotran.world.Barrier
import robotran.world.Goal
import robotran.world.GoalCondition.Reach
import robotran.world.GoalCondition.StayOut
import robotran.world.Lamp
import robotran.world.MovableBlock
import robotran.world.Paper
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class MeasuringTest {
    private val world = World(
        title = "Measured",
        paper = Paper(100.0, 80.0),
        robots = listOf(RobotPlacement(Pose(30.0, 20.0, 90.0))),
        barriers = listOf(Barrier(Shape.Rectangle(Point(90.0, 20.0), 10.0, 4.0))),
        blocks = listOf(MovableBlock(Shape.Rectangle(Point(60.0, 30.0), 6.0, 6.0))),
        lamps = listOf(Lamp(Point(20.0, 70.0))),
        goals = listOf(
            Goal(StayOut(Shape.Circle(Point(50.0, 40.0), 3.0))),
            Goal(Reach(Shape.Circle(Point(60.0, 60.0), 6.0))),
        ),
    )

    @Test
    fun `a length is in centimetres, a turn to the left is positive and one to the right is negative`() {
        val ruler = Measuring(Point(10.0, 10.0), Point(40.0, 50.0), MeasuringBase.Heading(0.0))
        assertEquals(50.0, ruler.centimetres, 1e-9)
        assertEquals(53.130, ruler.degrees, 1e-3)
        assertEquals(-36.870, ruler.copy(base = MeasuringBase.Heading(90.0)).degrees, 1e-3)
        assertEquals(-126.870, ruler.copy(base = MeasuringBase.Heading(-180.0)).degrees, 1e-3)
    }

    @Test
    fun `an angle can be measured between three points, and keeps the third when its middle moves`() {
        val ruler = Measuring(Point(0.0, 0.0), Point(0.0, 10.0), MeasuringBase.Heading(0.0))
        val three = ruler.moved(MeasuringEnd.BASE, SnappedPlace(Point(-10.0, 0.0)))
        assertEquals(-90.0, three.degrees, 1e-9)
        assertEquals(
            Point(-10.0, 0.0),
            three.moved(MeasuringEnd.FROM, SnappedPlace(Point(5.0, 5.0))).placeOf(MeasuringEnd.BASE),
        )
    }

    @Test
    fun `a ruler without length has no angle`() =
        assertEquals(0.0, Measuring(Point(1.0, 1.0), Point(1.0, 1.0), MeasuringBase.Heading(45.0)).degrees)

    @Test
    fun `at first it measures from the robot to the place that it has to reach`() = inWorld { workshop ->
        val ruler = assertNotNull(measuringFrom(workshop.state.world, workshop.state.session, 0))
        assertEquals(Point(30.0, 20.0), ruler.from)
        assertEquals(Point(60.0, 60.0), ruler.to)
        assertEquals(50.0, ruler.centimetres, 1e-9)
        assertEquals(-36.870, ruler.degrees, 1e-3)
        assertNull(measuringFrom(workshop.state.world, workshop.state.session, 1))
    }

    @Test
    fun `what it says is what a program needs to reach the goal`() = inWorld { workshop ->
        val ruler = assertNotNull(measuringFrom(workshop.state.world, workshop.state.session, 0))
        workshop.handle(
            ProgramEvent.ProgramEdited("turn right ${-ruler.degrees.toInt()}\nforward ${ruler.centimetres.toInt()}"),
        )
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(60_000)
        val pose = workshop.state.session.robot.pose
        assertEquals(60.0, pose.x, 3.0)
        assertEquals(60.0, pose.y, 3.0)
    }

    @Test
    fun `robot, goals and things attract it, and the robot brings where it looks`() = inWorld { workshop ->
        val places = placesToMeasure(workshop.state.world, workshop.state.session)
        assertEquals(
            SnappedPlace(Point(30.0, 20.0), MeasuredThing.ROBOT, heading = 90.0),
            places.snapped(Point(30.8, 20.5), 1.0),
        )
        assertEquals(MeasuredThing.GOAL, places.snapped(Point(60.4, 60.0), 1.0).thing)
        assertEquals(MeasuredThing.LAMP, places.snapped(Point(20.0, 69.5), 1.0).thing)
        assertEquals(MeasuredThing.BLOCK, places.snapped(Point(60.3, 30.3), 1.0).thing)
        assertEquals(Point(85.0, 18.0), places.snapped(Point(85.2, 17.9), 1.0).point)
        assertEquals(SnappedPlace(Point(10.3, 11.0)), places.snapped(Point(10.28, 11.04), 1.0))
    }

    @Test
    fun `a key goes through robot, goals, lamps and blocks, and begins again`() = inWorld { workshop ->
        val places = placesToMeasure(workshop.state.world, workshop.state.session)
        val seen = generateSequence(places.after(Point(1.0, 1.0))) {
            places.after(it.point)
        }.take(6).map { it.thing }.toList()
        val round =
            listOf(MeasuredThing.ROBOT, MeasuredThing.GOAL, MeasuredThing.GOAL, MeasuredThing.LAMP, MeasuredThing.BLOCK)
        assertEquals(round + MeasuredThing.ROBOT, seen)
        assertNull(emptyList<SnappedPlace>().after(Point(0.0, 0.0)))
        val robot = places.first { it.thing == MeasuredThing.ROBOT }
        assertEquals(MeasuredThing.GOAL, (listOf(robot) + places).after(robot.point)?.thing, "two at one place")
    }

    @Test
    fun `measuring puts nothing into the world and records nothing, and another world has none`() =
        inWorld { workshop ->
            val before = workshop.project.world to workshop.state.session
            workshop.handle(SheetEvent.MeasuringChanged(measuringFrom(workshop.state.world, workshop.state.session, 0)))
            assertNotNull(workshop.state.sheet.measuring)
            assertEquals(before, workshop.project.world to workshop.state.session)
            assertTrue(workshop.inputs.isEmpty())
            workshop.services.editor.changeWorld(world.copy(title = "Another"))
            assertNull(workshop.state.sheet.measuring)
        }

    private fun inWorld(check: (Workshop) -> Unit) {
        val workshop = runBlocking { Workshop(Project(world), loadPhysicsEngine()) }
        try {
            check(workshop)
        } finally {
            workshop.close()
        }
    }
}
