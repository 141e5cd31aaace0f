package robotran.ui.worldedit

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import robotran.ui.world.tags.WorldTags
import robotran.world.MarkFigure
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.PaletteItem
import robotran.worldediting.WorldEdit
import robotran.worldediting.things
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class EditByKeyboardTest {
    private val robot = ElementRef(ElementKind.ROBOT, 0)

    @Test
    fun `Tab goes through the things and out of the sheet behind the last`() = onEditor {
        assertTrue(sheetFocused())
        key(Key.Tab)
        assertEquals(robot, editing.only)
        key(Key.Tab)
        assertEquals(ElementRef(ElementKind.WALL, 0), editing.only)
        shift(Key.Tab)
        assertEquals(robot, editing.only)
        repeat(world.things().size - 1) { key(Key.Tab) }
        assertTrue(sheetFocused())
        key(Key.Tab)
        assertTrue(!sheetFocused())
    }

    @Test
    fun `arrows move on the grid and finely, and R turns both ways`() = onEditor {
        key(Key.Tab)
        key(Key.DirectionRight)
        key(Key.DirectionUp)
        shift(Key.DirectionLeft)
        assertEquals(Pose(40.9, 31.0, 0.0), world.start)
        key(Key.R)
        assertEquals(15.0, world.start.heading)
        shift(Key.R)
        shift(Key.R)
        assertEquals(-15.0, world.start.heading)
    }

    @Test
    fun `plus, minus, Delete, Escape and Ctrl do what they do everywhere`() = onEditor {
        put(PaletteItem.DOT, 75.0, 60.0)
        key(Key.Equals)
        assertEquals(6.6, radius())
        key(Key.Minus)
        assertEquals(6.0, radius())
        control(Key.C)
        control(Key.V)
        control(Key.D)
        assertEquals(3, world.marks.size)
        control(Key.Z)
        assertEquals(2, world.marks.size)
        control(Key.Y)
        assertEquals(3, world.marks.size)
        control(Key.A)
        assertEquals(world.things().size, editing.selection.size)
        key(Key.G)
        assertEquals(1, editing.groups.size)
        shift(Key.G)
        assertEquals(0, editing.groups.size)
        key(Key.Escape)
        assertEquals(emptySet(), editing.selection)
        make(WorldEdit.Select(ElementRef(ElementKind.MARK, 0)))
        key(Key.Delete)
        assertEquals(2, world.marks.size)
    }

    @Test
    fun `the last robot cannot be deleted, and the reason is told`() = onEditor {
        key(Key.Tab)
        key(Key.Delete)
        assertEquals(1, world.robots.size)
        assertTrue(isThere(WorldTags.EDIT_HINTS))
    }

    @Test
    fun `a screen reader is told what is chosen`() = onEditor {
        key(Key.Tab)
        val described = screen.onNodeWithTag(WorldTags.EDIT_SHEET)
            .fetchSemanticsNode().config.getOrNull(SemanticsProperties.StateDescription)
        assertEquals("Chosen: Robot yellow", described)
    }

    private fun EditorTest.sheetFocused(): Boolean =
        screen.onNodeWithTag(WorldTags.EDIT_SHEET).fetchSemanticsNode().config.getOrNull(SemanticsProperties.Focused) ==
            true

    private fun EditorTest.radius(): Double =
        ((world.marks.first().figure as MarkFigure.Area).shape as Shape.Circle).radius
}
