package robotran.worldediting

import robotran.world.LightFacing
import robotran.world.WorldLimits
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class MovingTest {
    private val box = emptySheet().with(PaletteItem.BOX, 80.0, 45.0)

    @Test
    fun `a thing follows the finger onto the grid`() {
        val alone = box.after(WorldEdit.Snap(Snapping(toOthers = false)))
        val moved = alone.drag(DragHandle.Body, Point(80.0, 45.0), Point(84.4, 38.3))
        assertNear(Point(84.0, 38.0), moved.chosenForm.middle)
        assertEquals(1, moved.history.past.size - box.history.past.size)
        moved.assertSound()
    }

    @Test
    fun `without a grid and others it follows exactly`() {
        val moved = box.after(
            WorldEdit.Snap(Snapping(0.0, 0.0, toOthers = false)),
        ).drag(DragHandle.Body, Point(80.0, 45.0), Point(84.4, 38.3))
        assertNear(Point(84.4, 38.3), moved.chosenForm.middle)
    }

    @Test
    fun `near another thing it is drawn to its edge and the line is shown`() {
        val two = box.with(PaletteItem.DOT, 50.0, 20.0)
        val held = two.after(
            WorldEdit.StartDrag(DragHandle.Body, Point(50.0, 20.0)),
            WorldEdit.DragTo(Point(78.9, 20.0), REACH),
        )
        assertEquals(listOf(Guide(isUpright = true, 72.0)), held.guides.filter { it.isUpright })
        assertNear(Point(78.0, 20.0), held.chosenForm.middle)
        assertEquals(emptyList(), held.after(WorldEdit.Drop).guides)
    }

    @Test
    fun `what is let go comes back and is no step`() {
        val back = box.after(
            WorldEdit.StartDrag(DragHandle.Body, Point(80.0, 45.0)),
            WorldEdit.DragTo(Point(20.0, 20.0), REACH),
            WorldEdit.CancelDrag,
        )
        assertEquals(box.world, back.world)
        assertEquals(box.history, back.history)
    }

    @Test
    fun `nothing can be dragged out of all sight`() {
        val far = box.drag(DragHandle.Body, Point(80.0, 45.0), Point(1e7, 45.0))
        assertEquals(box.world, far.world)
        assertEquals(WorldEditError.TooFar, box.after(WorldEdit.Nudge(1e7, 0.0)).error)
    }

    @Test
    fun `a handle draws a side and the other side stays`() {
        val right = box.handle(DragHandle.Size(SizeSide.RIGHT))
        val wider = box.drag(DragHandle.Size(SizeSide.RIGHT), right, Point(right.x + 10, right.y + 3))
        assertEquals(Shape.Rectangle(Point(85.0, 45.0), 26.0, 10.0), (wider.chosenForm as Form.Area).shape)
        val corner = wider.handle(DragHandle.Size(SizeSide.TOP_LEFT))
        val larger = wider.drag(DragHandle.Size(SizeSide.TOP_LEFT), corner, Point(corner.x - 2, corner.y + 4))
        assertEquals(Shape.Rectangle(Point(84.0, 47.0), 28.0, 14.0), (larger.chosenForm as Form.Area).shape)
    }

    @Test
    fun `a handle of a turned box draws along the box`() {
        val turned = box.after(WorldEdit.TurnBy(90.0))
        val right = turned.handle(DragHandle.Size(SizeSide.RIGHT))
        assertNear(Point(80.0, 53.0), right)
        val wider = turned.drag(DragHandle.Size(SizeSide.RIGHT), right, Point(80.0, 57.0))
        assertEquals(20.0, ((wider.chosenForm as Form.Area).shape as Shape.Rectangle).width)
        assertNear(Point(80.0, 47.0), wider.chosenForm.middle)
    }

    @Test
    fun `a circle grows about its middle and never vanishes`() {
        val dot = emptySheet().with(PaletteItem.DOT, 80.0, 45.0)
        val larger = dot.drag(
            DragHandle.Size(SizeSide.TOP),
            dot.handle(DragHandle.Size(SizeSide.TOP)),
            Point(80.0, 55.0),
        )
        assertEquals(Shape.Circle(Point(80.0, 45.0), 10.0), (larger.chosenForm as Form.Area).shape)
        val min = dot.drag(DragHandle.Size(SizeSide.TOP), dot.handle(DragHandle.Size(SizeSide.TOP)), Point(80.0, 20.0))
        assertTrue(((min.chosenForm as Form.Area).shape as Shape.Circle).radius >= WorldLimits.MINIMUM_THICKNESS)
        min.assertSound()
    }

    @Test
    fun `the handle above turns by fifteen degrees`() {
        val top = box.handle(DragHandle.Turn)
        val turned = box.drag(DragHandle.Turn, top, Point(80.0 - 10, 45.0 + 9))
        assertEquals(45.0, ((turned.chosenForm as Form.Area).shape as Shape.Rectangle).angle)
        val free = box.after(WorldEdit.Snap(Snapping(angle = 0.0))).drag(
            DragHandle.Turn,
            top,
            Point(80.0, 45.0).let {
                Point(
                    it.x - 1.75,
                    it.y + 10,
                )
            },
        )
        assertEquals(10.0, ((free.chosenForm as Form.Area).shape as Shape.Rectangle).angle)
    }

    @Test
    fun `a robot is turned by the handle before it and moved by itself`() {
        val robot = emptySheet().after(WorldEdit.Select(ElementRef(ElementKind.ROBOT, 0)))
        val turned = robot.drag(DragHandle.Turn, robot.handle(DragHandle.Turn), Point(30.0, 80.0))
        assertEquals(Pose(30.0, 45.0, 90.0), turned.world.start)
        val moved = turned.drag(DragHandle.Body, Point(31.0, 44.0), Point(41.0, 44.0))
        assertEquals(Pose(40.0, 45.0, 90.0), moved.world.start)
        val robotNow = (moved.chosenPiece as Element.OfRobot).robot
        val facing = moved.after(
            WorldEdit.Change(
                ElementRef(ElementKind.ROBOT, 0),
                Element.OfRobot(robotNow.copy(lightFacing = LightFacing.FORWARD)),
            ),
        )
        assertEquals(LightFacing.FORWARD, facing.world.robots.first().lightFacing)
        facing.assertSound()
    }

    @Test
    fun `ends of walls meet`() {
        val two = emptySheet().with(PaletteItem.WALL, 80.0, 30.0).with(PaletteItem.WALL, 80.0, 60.5)
        val joined = two.drag(DragHandle.Corner(0), two.handle(DragHandle.Corner(0)), Point(65.7, 31.0))
        assertEquals(joined.world.walls[0].from, joined.world.walls[1].from)
    }

    @Test
    fun `the middle of an edge becomes a corner that is drawn out, and corners can go down to three`() {
        val triangle = emptySheet().with(PaletteItem.CORNERED_AREA, 80.0, 45.0)
        val four = triangle.drag(DragHandle.Edge(0), triangle.handle(DragHandle.Edge(0)), Point(80.0, 20.0))
        assertEquals(4, four.chosenForm.corners.size)
        val thing = checkNotNull(four.only)
        val three = four.after(WorldEdit.RemoveCorner(thing, 1))
        assertEquals(3, three.chosenForm.corners.size)
        assertEquals(WorldEditError.TooFewCorners, three.after(WorldEdit.RemoveCorner(thing, 1)).error)
        assertEquals(4, three.after(WorldEdit.AddCorner(thing, 2)).chosenForm.corners.size)
        assertEquals(
            Point(70.0, 70.0),
            three.after(WorldEdit.MoveCorner(thing, 0, Point(70.0, 70.0))).chosenForm.corners[0],
        )
    }

    @Test
    fun `a polygon whose edges cross says so until it is mended`() {
        val square = box.after(WorldEdit.MakeCorners(checkNotNull(box.only)))
        assertEquals(4, square.chosenForm.corners.size)
        val tangled = square.after(WorldEdit.MoveCorner(checkNotNull(square.only), 0, Point(80.0, 60.0)))
        assertEquals(
            listOf<ValidationError>(ValidationError.SelfIntersecting(ElementRef(ElementKind.BARRIER, 0))),
            tangled.errors,
        )
        tangled.after(WorldEdit.Undo).assertSound()
    }

    @Test
    fun `plus and minus make a thing larger and smaller about its middle`() {
        val larger = box.after(WorldEdit.ScaleBy(1.5))
        assertEquals(Shape.Rectangle(Point(80.0, 45.0), 24.0, 15.0), (larger.chosenForm as Form.Area).shape)
        val min = (1..40).fold(box) { now, _ -> now.after(WorldEdit.ScaleBy(0.5)) }
        assertEquals(WorldEditError.InvalidSize, min.error)
        min.after(WorldEdit.Select(null)).assertSound()
    }

    @Test
    fun `several things turn and grow together about their common middle`() {
        val two = emptySheet().with(PaletteItem.DOT, 60.0, 20.0).with(PaletteItem.DOT, 80.0, 20.0)
            .after(WorldEdit.SelectWithin(robotran.world.geometry.Bounds(40.0, 5.0, 100.0, 30.0)))
        assertEquals(2, two.selection.size)
        val turned = two.after(WorldEdit.TurnBy(90.0))
        assertEquals(listOf(10.0, 30.0), turned.world.marks.map { checkNotNull(Element.OfMark(it).form).middle.y })
        val corner = two.handle(DragHandle.Size(SizeSide.TOP_RIGHT))
        val grown = two.drag(DragHandle.Size(SizeSide.TOP_RIGHT), corner, Point(corner.x + 32, corner.y + 12))
        val radii = grown.world.marks.map { ((Element.OfMark(it).form as Form.Area).shape as Shape.Circle).radius }
        assertEquals(listOf(12.0, 12.0), radii)
    }

    @Test
    fun `things are put in one line with each other and one alone with the paper`() {
        val two = box.with(
            PaletteItem.DOT,
            50.0,
            20.0,
        ).after(WorldEdit.SelectAll, WorldEdit.Select(ElementRef(ElementKind.ROBOT, 0), adding = true))
        val left = two.after(WorldEdit.Align(AlignSide.LEFT))
        assertEquals(listOf(44.0, 44.0), left.selection.map { checkNotNull(left.world.piece(it)?.form).bounds.left })
        val middle = box.after(WorldEdit.Align(AlignSide.CENTRE), WorldEdit.Align(AlignSide.TOP))
        assertNear(Point(60.0, 85.0), middle.chosenForm.middle)
    }

    @Test
    fun `a heading is found as it is on every platform`() {
        val from = Point(3.0, 4.0)
        val headings = listOf(
            Point(5.0, 4.0) to 0.0,
            Point(3.0, 6.0) to 90.0,
            Point(0.0, 4.0) to 180.0,
            Point(3.0, 0.0) to -90.0,
            Point(4.0, 3.0) to -45.0,
        )
        for ((to, heading) in headings) assertEquals(heading, headingTo(from, to))
        assertEquals(26.6, headingTo(from, Point(5.0, 5.0)))
        assertEquals(null, headingTo(from, from))
    }
}
