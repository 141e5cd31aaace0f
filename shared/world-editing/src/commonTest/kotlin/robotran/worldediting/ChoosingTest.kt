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
        val first = two.after(WorldEdit.Select(null), WorldEdit.TapAt(Point(80.0, 45.0), REACH))
        assertEquals(ElementRef(ElementKind.BLOCK, 0), first.only)
        assertEquals(ElementRef(ElementKind.MARK, 0), first.after(WorldEdit.TapAt(Point(80.0, 45.0), REACH)).only)
        assertEquals(emptySet(), first.after(WorldEdit.TapAt(Point(5.0, 80.0), REACH)).selection)
    }

    @Test
    fun `with several switched on, taps add and take away`() {
        val isMultiSelect = two.after(WorldEdit.Select(null), WorldEdit.SetMultiSelect(true))
            .after(WorldEdit.TapAt(Point(80.0, 45.0), REACH), WorldEdit.TapAt(Point(30.0, 45.0), REACH))
        assertEquals(setOf(ElementRef(ElementKind.BLOCK, 0), robot), isMultiSelect.selection)
        assertEquals(setOf(robot), isMultiSelect.after(WorldEdit.TapAt(Point(80.0, 45.0), REACH)).selection)
        assertEquals(isMultiSelect.selection, isMultiSelect.after(WorldEdit.TapAt(Point(5.0, 85.0), REACH)).selection)
    }

    @Test
    fun `the Tab key goes through everything, the robot first, and round again, both ways`() {
        val all = two.world.things().size
        val visited = generateSequence(two.after(WorldEdit.Select(null), WorldEdit.SelectNext())) {
            it.after(WorldEdit.SelectNext())
        }
            .take(all).map { it.only }.toList()
        assertEquals(robot, visited.first())
        assertEquals(all, visited.toSet().size)
        assertEquals(robot, two.after(WorldEdit.Select(checkNotNull(visited.last())), WorldEdit.SelectNext()).only)
        assertEquals(visited.last(), two.after(WorldEdit.Select(robot), WorldEdit.SelectNext(backwards = true)).only)
    }

    @Test
    fun `a group is chosen and moved as one, and can be taken apart`() {
        val grouped = two.after(
            WorldEdit.SelectAll,
            WorldEdit.Select(robot, adding = true),
            WorldEdit.Group,
            WorldEdit.Select(null),
        )
            .after(WorldEdit.TapAt(Point(80.0, 45.0), REACH))
        assertEquals(2, grouped.selection.size)
        val moved = grouped.after(WorldEdit.Nudge(1.0, 0.0))
        assertTrue(moved.selection.all { checkNotNull(moved.world.piece(it)?.form).middle.x == 81.0 })
        val apart = moved.after(WorldEdit.Ungroup, WorldEdit.Select(ElementRef(ElementKind.BLOCK, 0)))
        assertEquals(1, apart.selection.size)
        assertEquals(2, apart.after(WorldEdit.Undo, WorldEdit.Select(ElementRef(ElementKind.BLOCK, 0))).selection.size)
    }

    @Test
    fun `a group survives that something else is deleted`() {
        val three = emptySheet().with(
            PaletteItem.DOT,
            60.0,
            20.0,
        ).with(PaletteItem.DOT, 80.0, 20.0).with(PaletteItem.DOT, 100.0, 20.0)
        val grouped = three.after(
            WorldEdit.Select(ElementRef(ElementKind.MARK, 1)),
            WorldEdit.Select(ElementRef(ElementKind.MARK, 2), adding = true),
            WorldEdit.Group,
            WorldEdit.Select(ElementRef(ElementKind.MARK, 0)),
            WorldEdit.Delete,
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
        val back = three.after(WorldEdit.Restack(StackOrder.TO_BACK))
        assertEquals(top, back.world.marks.first())
        assertEquals(ElementRef(ElementKind.MARK, 0), back.only)
        assertEquals(top, back.after(WorldEdit.Restack(StackOrder.FORWARD)).world.marks[1])
        assertEquals(three.world, back.after(WorldEdit.Restack(StackOrder.TO_FRONT)).world)
    }
}
