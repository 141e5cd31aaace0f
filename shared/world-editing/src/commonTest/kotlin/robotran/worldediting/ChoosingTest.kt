package robotran.worldediting

import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class ChoosingTest {
    private val robot = ElementRef(ElementKind.ROBOT, 0)
    private val two = emptySheet().with(PaletteItem.AREA, 80.0, 45.0).with(PaletteItem.BLOCK, 80.0, 45.0)

    @Test
    fun `a tap chooses what lies on top and another tap what lies below`() {
        val first = two.after(Edit.Select(null), Edit.TapAt(Point(80.0, 45.0), REACH))
        assertEquals(ElementRef(ElementKind.BLOCK, 0), first.only)
        assertEquals(ElementRef(ElementKind.MARK, 0), first.after(Edit.TapAt(Point(80.0, 45.0), REACH)).only)
        assertEquals(emptySet(), first.after(Edit.TapAt(Point(5.0, 80.0), REACH)).selection)
    }

    @Test
    fun `with several switched on, taps add and take away`() {
        val several = two.after(Edit.Select(null), Edit.SelectSeveral(true))
            .after(Edit.TapAt(Point(80.0, 45.0), REACH), Edit.TapAt(Point(30.0, 45.0), REACH))
        assertEquals(setOf(ElementRef(ElementKind.BLOCK, 0), robot), several.selection)
        assertEquals(setOf(robot), several.after(Edit.TapAt(Point(80.0, 45.0), REACH)).selection)
        assertEquals(several.selection, several.after(Edit.TapAt(Point(5.0, 85.0), REACH)).selection)
    }

    @Test
    fun `the Tab key goes through everything, the robot first, and round again, both ways`() {
        val all = two.world.things().size
        val visited = generateSequence(two.after(Edit.Select(null), Edit.SelectNext())) { it.after(Edit.SelectNext()) }
            .take(all).map { it.only }.toList()
        assertEquals(robot, visited.first())
        assertEquals(all, visited.toSet().size)
        assertEquals(robot, two.after(Edit.Select(checkNotNull(visited.last())), Edit.SelectNext()).only)
        assertEquals(visited.last(), two.after(Edit.Select(robot), Edit.SelectNext(backwards = true)).only)
    }

    @Test
    fun `a group is chosen and moved as one, and can be taken apart`() {
        val grouped = two.after(Edit.SelectAll, Edit.Select(robot, adding = true), Edit.Group, Edit.Select(null))
            .after(Edit.TapAt(Point(80.0, 45.0), REACH))
        assertEquals(2, grouped.selection.size)
        val moved = grouped.after(Edit.Nudge(1.0, 0.0))
        assertTrue(moved.selection.all { checkNotNull(moved.world.piece(it)?.form).middle.x == 81.0 })
        val apart = moved.after(Edit.Ungroup, Edit.Select(ElementRef(ElementKind.BLOCK, 0)))
        assertEquals(1, apart.selection.size)
        assertEquals(2, apart.after(Edit.Undo, Edit.Select(ElementRef(ElementKind.BLOCK, 0))).selection.size)
    }

    @Test
    fun `a group survives that something else is deleted`() {
        val three = emptySheet().with(
            PaletteItem.DOT,
            60.0,
            20.0,
        ).with(PaletteItem.DOT, 80.0, 20.0).with(PaletteItem.DOT, 100.0, 20.0)
        val grouped = three.after(
            Edit.Select(ElementRef(ElementKind.MARK, 1)),
            Edit.Select(ElementRef(ElementKind.MARK, 2), adding = true),
            Edit.Group,
            Edit.Select(ElementRef(ElementKind.MARK, 0)),
            Edit.Delete,
        )
        assertEquals(listOf(setOf(ElementRef(ElementKind.MARK, 0), ElementRef(ElementKind.MARK, 1))), grouped.groups)
    }

    @Test
    fun `marks change their order and stay chosen`() {
        val three = emptySheet().with(
            PaletteItem.DOT,
            60.0,
            20.0,
        ).with(PaletteItem.AREA, 80.0, 20.0).with(PaletteItem.LINE, 100.0, 20.0)
        val top = three.world.marks.last()
        val back = three.after(Edit.Restack(StackOrder.TO_BACK))
        assertEquals(top, back.world.marks.first())
        assertEquals(ElementRef(ElementKind.MARK, 0), back.only)
        assertEquals(top, back.after(Edit.Restack(StackOrder.FORWARD)).world.marks[1])
        assertEquals(three.world, back.after(Edit.Restack(StackOrder.TO_FRONT)).world)
    }
}
