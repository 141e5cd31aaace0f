package robotran.ui.sheet

import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.InkStroke
import robotran.simulation.state.LampState
import robotran.simulation.state.TrailPiece
import robotran.ui.sheet.SheetScenes.with
import robotran.workshop.state.SheetLayer
import robotran.world.Barrier
import robotran.world.Goal
import robotran.world.GoalCondition.All
import robotran.world.GoalCondition.InOrder
import robotran.world.GoalCondition.PlaySound
import robotran.world.GoalCondition.Reach
import robotran.world.GoalCondition.StayIn
import robotran.world.GoalCondition.StayOut
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.ReadyRobots
import robotran.world.RobotColour
import robotran.world.RobotPlacement
import robotran.world.Shade
import robotran.world.Template
import robotran.world.Wall
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class SheetThingsTest {
    private val paper = SheetColours.LIGHT.paper

    @Test
    fun `a mark has its own grey and the last one lies on top`() {
        val world = with {
            copy(
                marks = listOf(
                    area(Shape.Circle(Point(50.0, 20.0), 5.0), Shade.Grey(0.0)),
                    area(box(50.0, 20.0), Shade.Grey(1.0)),
                ),
            )
        }
        assertEquals(Color.White, closeUp(world).at(50.0, 20.0))
        assertEquals(Color.Black, closeUp(world).at(54.0, 20.0))
        assertEquals(paper, closeUp(world).at(56.0, 20.0))
    }

    @Test
    fun `a blue mark has dots and a red one has none`() {
        val blue = with { copy(marks = listOf(area(box(50.0, 20.0, 8.0), Shade.Colour(0, 0, 200)))) }
        val red = with { copy(marks = listOf(area(box(50.0, 20.0, 8.0), Shade.Colour(200, 0, 0)))) }
        assertTrue(closeUp(blue).coloursAround(50.0, 20.0, 1.0).size > 1)
        assertEquals(setOf(Color(200, 0, 0)), closeUp(red).coloursAround(50.0, 20.0, 1.0))
    }

    @Test
    fun `a line mark is as wide as it says and only a closed one comes back to its beginning`() {
        val points = listOf(Point(40.0, 10.0), Point(60.0, 10.0), Point(60.0, 30.0))
        val open = closeUp(with { copy(marks = listOf(Mark(MarkFigure.Line(points, 2.0)))) })
        val closed = closeUp(with { copy(marks = listOf(Mark(MarkFigure.Line(points, 2.0, closed = true)))) })
        assertEquals(Color.Black, open.at(50.0, 10.9))
        assertEquals(paper, open.at(50.0, 11.1))
        assertEquals(paper, open.at(50.0, 20.0))
        assertEquals(Color.Black, closed.at(50.0, 20.0))
    }

    @Test
    fun `a grey map has its rows from the top down and is see-through at its points`() {
        val map = MarkFigure.GreyMap(Point(40.0, 10.0), 2.0, listOf("0f", ".8"))
        val picture = closeUp(with { copy(marks = listOf(Mark(map))) })
        assertEquals(Color.Black, picture.at(41.0, 13.0))
        assertEquals(Color.White, picture.at(43.0, 13.0))
        assertEquals(paper, picture.at(41.0, 11.0))
        assertEquals(Color(136, 136, 136), picture.at(43.0, 11.0))
    }

    @Test
    fun `barriers look like walls whatever their form and direction`() {
        val corners = listOf(Point(70.0, 10.0), Point(76.0, 10.0), Point(76.0, 16.0))
        val world = with {
            copy(
                walls = listOf(Wall(Point(30.0, 12.0), Point(30.0, 30.0), 2.0)),
                barriers = listOf(
                    Barrier(Shape.Rectangle(Point(45.0, 20.0), 10.0, 2.0, 90.0)),
                    Barrier(Shape.Circle(Point(60.0, 20.0), 4.0)),
                    Barrier(Shape.Polygon(corners)),
                    Barrier(Shape.Polygon(corners.reversed())),
                ),
            )
        }
        val picture = closeUp(world)
        val solid = setOf(SheetColours.WALL, SheetColours.WALL_HATCHING)
        for ((x, y) in listOf(30.0 to 20.0, 45.0 to 24.0, 60.0 to 20.0, 74.5 to 12.5)) {
            assertTrue(picture.coloursAround(x, y, 0.8).containsAll(solid), "no hatching at $x, $y")
        }
        assertEquals(paper, picture.at(49.0, 20.0))
    }

    @Test
    fun `a block is drawn where it is now and turned`() {
        val world = with { copy(blocks = listOf(MovableBlock(Shape.Rectangle(Point(50.0, 20.0), 10.0, 2.0)))) }
        val moved = closeUp(world, SheetScenes.state(world, blocks = listOf(Pose(20.0, 5.0, 90.0))))
        assertNotEquals(paper, closeUp(world).at(54.0, 20.6))
        assertEquals(paper, moved.at(54.0, 20.6))
        assertNotEquals(paper, moved.at(70.6, 29.0))
        assertEquals(paper, moved.at(74.0, 25.0))
    }

    @Test
    fun `a lamp lights what is before it but not behind a barrier, and nothing when it is off`() {
        val lamp = Lamp(Point(40.0, 30.0), direction = 0.0, cone = 90.0)
        val world =
            with {
                copy(lamps = listOf(lamp), barriers = listOf(Barrier(Shape.Rectangle(Point(55.0, 30.0), 1.0, 6.0))))
            }
        val picture = closeUp(world)
        assertNotEquals(paper, picture.at(50.0, 30.0))
        assertNotEquals(paper, picture.at(60.0, 40.0))
        assertEquals(paper, picture.at(60.0, 30.0))
        assertEquals(paper, picture.at(30.0, 30.0))
        val off = closeUp(world, SheetScenes.state(world, lamps = listOf(LampState(lamp.place, on = false))))
        assertEquals(paper, off.at(50.0, 30.0))
    }

    @Test
    fun `the shadow of a block goes where the block is pushed`() {
        val block = MovableBlock(Shape.Rectangle(Point(50.0, 10.0), 6.0, 6.0))
        val world = with { copy(lamps = listOf(Lamp(Point(40.0, 30.0))), blocks = listOf(block)) }
        val pushed = SheetScenes.state(world, blocks = listOf(Pose(0.0, 20.0, 0.0)))
        assertNotEquals(paper, closeUp(world).at(60.0, 30.0))
        assertEquals(paper, closeUp(world, pushed).at(60.0, 30.0))
    }

    @Test
    fun `a robot casts a shadow, but not when the lamp stands on it`() {
        val lamp = Lamp(Point(40.0, 30.0))
        val world = with { copy(lamps = listOf(lamp), robots = listOf(RobotPlacement(Pose(55.0, 30.0, 0.0)))) }
        val picture = closeUp(world)
        assertEquals(paper, picture.at(68.0, 30.0))
        assertNotEquals(paper, picture.at(55.0, 15.0))
        val under = closeUp(world, SheetScenes.state(world, poses = listOf(Pose(40.0, 30.0, 0.0))))
        assertNotEquals(paper, under.at(55.0, 30.0))
    }

    @Test
    fun `a region that had to be cut open has no seam`() {
        val slit = listOf(
            20.0 to 5.0,
            80.0 to 5.0,
            80.0 to 40.0,
            50.1 to 40.0,
            50.1 to 30.0,
            60.0 to 30.0,
            60.0 to 15.0,
            40.0 to 15.0,
            40.0 to 30.0,
            49.9 to 30.0,
            49.9 to 40.0,
            20.0 to 40.0,
        )
        val region = Shape.Polygon(slit.map { (x, y) -> Point(x, y) })
        val picture = closeUp(with { copy(goals = listOf(Goal(Reach(region)))) })
        assertEquals(picture.at(30.0, 35.0), picture.at(50.0, 35.0))
        assertEquals(paper, picture.at(50.0, 22.0))
        assertNotEquals(picture.at(30.0, 35.0), picture.at(45.0, 15.0))
    }

    @Test
    fun `what is wanted is drawn over the sheet, and goals are not if they are not wanted`() {
        val world = with { copy(goals = listOf(Goal(Reach(box(60.0, 20.0, 20.0))))) }
        val way = TrailPiece(0, listOf(Point(30.0, 40.0), Point(50.0, 40.0)))
        val state = SheetScenes.state(world).copy(trail = listOf(way))
        val plain = renderOn(world, 2000) { drawSheet(it, state, SheetColours.LIGHT, shown = emptySet()) }
        assertEquals(paper, plain.at(52.0, 12.0))
        assertEquals(setOf(paper), plain.coloursAround(40.0, 40.0, 2.0))
        val all = renderOn(world, 2000) { drawSheet(it, state, SheetColours.LIGHT, shown = SheetLayer.entries.toSet()) }
        assertNotEquals(paper, all.at(52.0, 12.0))
        assertTrue(all.coloursAround(40.0, 40.0, 2.0).size > 2)
    }

    @Test
    fun `a lamp that has been moved shines where it is now`() {
        val world = with { copy(lamps = listOf(Lamp(Point(30.0, 30.0)))) }
        val moved = closeUp(world, SheetScenes.state(world, lamps = listOf(LampState(Point(80.0, 30.0), on = true))))
        assertEquals(SheetColours.LAMP_CORE, moved.at(80.0, 30.0))
        assertNotEquals(SheetColours.LAMP_CORE, moved.at(30.0, 30.0))
    }

    @Test
    fun `a world is made ready for drawing once for each size`() {
        val fit = SheetFit(SheetScenes.everything, 2.0)
        val first = fit.into(Size(100f, 60f))
        assertTrue(fit.into(Size(100f, 60f)) === first)
        assertTrue(fit.into(Size(200f, 120f)) !== first)
    }

    @Test
    fun `a mark ends where the paper ends`() {
        val picture = closeUp(with { copy(marks = listOf(area(box(96.0, 20.0), Shade.Grey(0.0)))) })
        assertEquals(Color.Black, picture.at(95.5, 20.0))
        assertNotEquals(Color.Black, picture.at(96.5, 20.0))
    }

    @Test
    fun `each pen writes in its robot's colour, the first one in blue`() {
        val world = with { copy(robots = robots + RobotPlacement(Pose(80.0, 10.0, 0.0), "green", RobotColour.GREEN)) }
        val strokes = listOf(
            InkStroke(listOf(Point(40.0, 30.0), Point(60.0, 30.0))),
            InkStroke(listOf(Point(40.0, 40.0), Point(60.0, 40.0)), robot = 1),
        )
        val picture = closeUp(world, SheetScenes.state(world, strokes = strokes))
        assertEquals(SheetColours.INK, picture.at(50.0, 30.0))
        assertEquals(RobotColours.edge(RobotColour.GREEN), picture.at(50.0, 40.0))
    }

    @Test
    fun `each robot has a brick of its colour`() {
        for (colour in RobotColour.entries) {
            val picture =
                closeUp(with { copy(robots = listOf(RobotPlacement(Pose(40.0, 20.0, 0.0), colour = colour))) })
            val brick = RobotPlan(ReadyRobots.RCX_PENBOT).brick.box.left + 0.4
            assertEquals(RobotColours.brick(colour), picture.at(40.0 + brick, 20.0), colour.name)
        }
        assertEquals(RobotColour.entries.size, RobotColour.entries.map(RobotColours::brick).toSet().size)
    }

    @Test
    fun `a region to be reached is green, and fuller once it is reached`() {
        val world = with { copy(goals = listOf(Goal(Reach(box(60.0, 20.0, 20.0))))) }
        val before = closeUp(world).at(52.0, 12.0)
        val after = closeUp(
            world,
            SheetScenes.state(world, goals = listOf(SheetScenes.progress(GoalStatus.MET))),
        ).at(52.0, 12.0)
        assertTrue(before.green > before.red && after.red < before.red)
    }

    @Test
    fun `a region to keep out of is red and one to stay in is left plain`() {
        val keepOut = closeUp(with { copy(goals = listOf(Goal(All(listOf(Goal(StayOut(box(60.0, 20.0, 20.0)))))))) })
        assertTrue(keepOut.at(60.0, 20.0).let { it.red > it.green })
        val stayIn = closeUp(with { copy(goals = listOf(Goal(StayIn(box(60.0, 20.0, 20.0))))) })
        assertEquals(paper, stayIn.at(60.0, 20.0))
        assertTrue(SheetColours.STAY_IN in stayIn.coloursAround(60.0, 30.0, 2.0))
    }

    @Test
    fun `the drawing to be traced is dotted and ink covers it`() {
        val world = with { copy(template = Template(listOf(listOf(Point(40.0, 30.0), Point(60.0, 30.0))))) }
        val colours = closeUp(world).coloursAround(50.0, 30.0, 1.5)
        assertTrue(SheetColours.TEMPLATE in colours && paper in colours)
        val traced =
            closeUp(
                world,
                SheetScenes.state(world, strokes = listOf(InkStroke(listOf(Point(40.0, 30.0), Point(60.0, 30.0))))),
            )
        assertEquals(SheetColours.INK, traced.at(50.0, 30.0))
    }

    @Test
    fun `goals to be reached one after the other are numbered`() {
        val one = Goal(Reach(box(20.0, 20.0)))
        val two = Goal(Reach(box(60.0, 20.0)))
        val out = Goal(StayOut(box(40.0, 20.0)))
        val regions = goalRegions(listOf(out, Goal(InOrder(listOf(one, out, two))), one))
        assertEquals(listOf(null, 1, 2), regions.map { it.number })
        assertEquals(listOf(listOf(0), listOf(1, 0), listOf(1, 2)), regions.map { it.where })
        assertEquals(listOf(null), goalRegions(listOf(Goal(InOrder(listOf(one, Goal(PlaySound())))))).map { it.number })
    }

    @Test
    fun `the flag of a dented region is put where there is room for it`() {
        val hook = listOf(0.0 to 0.0, 40.0 to 0.0, 40.0 to 4.0, 12.0 to 4.0, 12.0 to 40.0, 0.0 to 40.0).map { (x, y) ->
            Point(x, y)
        }
        val (place, room) = roomiestPoint(Shape.Polygon(hook))
        assertTrue(place.x in 4.0..8.0 && place.y in 4.0..36.0, place.toString())
        assertTrue(room in 4.0..6.5, room.toString())
    }

    private fun area(shape: Shape, shade: Shade) = Mark(MarkFigure.Area(shape), shade)

    private fun box(x: Double, y: Double, side: Double = 2.0) = Shape.Rectangle(Point(x, y), side, side)

    /** The colours on a cross with this radius. */
    private fun ImageBitmap.coloursAround(x: Double, y: Double, reach: Double): Set<Color> =
        (-STEPS..STEPS).flatMap { listOf(at(x + reach * it / STEPS, y), at(x, y + reach * it / STEPS)) }.toSet()

    private companion object {
        const val STEPS = 40
    }
}
