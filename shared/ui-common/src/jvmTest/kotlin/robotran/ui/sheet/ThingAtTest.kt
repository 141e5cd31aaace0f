package robotran.ui.sheet

import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetElementKind
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class ThingAtTest {
    private val world = SheetScenes.everything
    private val state = SheetScenes.everythingLater

    private fun at(
        x: Double,
        y: Double,
        tolerance: Double = 0.0,
        kinds: Set<SheetElementKind> = SheetElementKind.entries.toSet(),
    ) = elementAt(world, state, Point(x, y), tolerance, kinds)

    @Test
    fun `everything is found where it is drawn`() {
        assertEquals(SheetElement(SheetElementKind.ROBOT, 0), at(24.0, 22.0))
        assertEquals(SheetElement(SheetElementKind.ROBOT, 1), at(86.0, 70.0))
        assertEquals(SheetElement(SheetElementKind.BLOCK, 0), at(39.0, 31.0))
        assertEquals(SheetElement(SheetElementKind.BARRIER, 1), at(38.0, 66.0))
        assertEquals(SheetElement(SheetElementKind.WALL, 0), at(60.0, 88.2))
        assertEquals(SheetElement(SheetElementKind.LAMP, 0), at(12.5, 76.0))
        assertEquals(SheetElement(SheetElementKind.MARK, 3), at(110.0, 24.0, kinds = setOf(SheetElementKind.MARK)))
        assertEquals(SheetElement(SheetElementKind.TEMPLATE, 0), at(20.0, 40.2, 0.5, setOf(SheetElementKind.TEMPLATE)))
        assertEquals(SheetElement(SheetElementKind.REGION, 0), at(10.0, 58.0, kinds = setOf(SheetElementKind.REGION)))
    }

    @Test
    fun `a block is found where it has been pushed and turned, not where it was`() {
        val shape = Shape.Rectangle(Point(40.0, 20.0), 10.0, 2.0)
        val one = SheetScenes.with { copy(blocks = listOf(robotran.world.MovableBlock(shape))) }
        val moved = SheetScenes.state(one, blocks = listOf(Pose(20.0, 5.0, 90.0)))
        assertEquals(SheetElement(SheetElementKind.BLOCK, 0), elementAt(one, moved, Point(60.0, 29.5), 0.0))
        assertNull(elementAt(one, moved, Point(44.0, 20.0), 0.0))
        assertNull(elementAt(one, moved, Point(64.0, 25.0), 0.0))
    }

    @Test
    fun `a finger that misses a lamp by a little has it, and by much has not`() {
        assertEquals(
            SheetElement(SheetElementKind.LAMP, 2),
            at(114.2, 56.0, tolerance = 2.0, kinds = setOf(SheetElementKind.LAMP)),
        )
        assertNull(at(116.0, 56.0, tolerance = 2.0, kinds = setOf(SheetElementKind.LAMP)))
    }
}
