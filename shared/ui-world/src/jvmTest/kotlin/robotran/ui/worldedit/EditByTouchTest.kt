package robotran.ui.worldedit

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performTouchInput
import robotran.ui.editing.drag
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.pixelsOf
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.LearningPage
import robotran.world.MarkFigure
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.worldediting.DragHandle
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.PaletteItem
import robotran.worldediting.Tool
import robotran.worldediting.WorldEdit
import robotran.worldediting.bounds
import robotran.worldediting.form
import robotran.worldediting.handlesOf
import robotran.worldediting.piece
import robotran.worldediting.things
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class EditByTouchTest {
    @Test
    fun `the editor opens from the strip and Done puts the robots into the new world`() = onTablet { workshop ->
        val editor = EditorTest(this, workshop)
        editor.tap(ScreenTags.EDIT_WORLD)
        editor.tap(WorldTags.palette(PaletteItem.LAMP))
        editor.tap(WorldTags.done(WorldTags.EDIT))
        assertEquals(null, workshop.state.worldEdit)
        assertEquals(1, workshop.state.world.lamps.size)
        assertEquals(1, workshop.project.world.lamps.size)
    }

    @Test
    fun `help on words does not lie over the editor`() = onTablet { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.HELP))
        pass(300)
        EditorTest(this, workshop).tap(ScreenTags.EDIT_WORLD)
        assertEquals(null, workshop.state.learning.page)
        assertNotEquals(null, workshop.state.worldEdit)
    }

    @Test
    fun `a tap on the palette puts each thing into the middle of what is seen`() = onEditor {
        for (item in PaletteItem.entries.take(6)) {
            val before = editing.world.things().size
            tap(WorldTags.palette(item))
            assertEquals(before + 1, editing.world.things().size, "$item is not put")
            assertEquals(1, editing.selection.size)
        }
    }

    @Test
    fun `a thing can be dragged from the palette to its place`() = onEditor {
        val sheet = screen.onNodeWithTag(WorldTags.EDIT_SHEET).fetchSemanticsNode().boundsInRoot
        val strip = screen.onNodeWithTag(WorldTags.palette(PaletteItem.LAMP)).fetchSemanticsNode().boundsInRoot
        val to = sheet.topLeft + place(80.0, 60.0) - strip.topLeft
        screen.onNodeWithTag(WorldTags.palette(PaletteItem.LAMP)).performTouchInput {
            down(center)
            for (step in 1..10) moveTo(center + (to - center) * (step / 10f))
            up()
        }
        screen.pass(200)
        assertEquals(1, world.lamps.size)
        assertTrue(
            world.lamps[0].place.let { it.x in 78.0..82.0 && it.y in 58.0..62.0 },
            "it is at ${world.lamps[0].place}",
        )
    }

    @Test
    fun `what is dragged from the palette is seen under the finger`() = onEditor {
        screen.onNodeWithTag(WorldTags.palette(PaletteItem.LAMP)).performTouchInput {
            down(center)
            for (step in 1..10) moveBy(Offset(30f, 0f))
        }
        screen.pass(100)
        val carried = screen.pixelsOf(WorldTags.CARRIED)
        val middle = (carried.width / 3..carried.width * 2 / 3).flatMap { x ->
            (carried.height / 3..carried.height * 2 / 3).map { y -> carried[x, y] }
        }
        assertTrue(middle.distinct().size > 1, "It is only a ring.")
        screen.onNodeWithTag(WorldTags.palette(PaletteItem.LAMP)).performTouchInput { up() }
    }

    @Test
    fun `a finger chooses, moves, resizes and turns`() = onEditor {
        put(PaletteItem.BOX, 75.0, 60.0)
        make(WorldEdit.Select(null))
        tapAt(75.0, 60.0)
        assertEquals(ElementRef(ElementKind.BARRIER, 0), editing.only)
        drag(place(75.0, 60.0), place(65.0, 50.0))
        assertEquals(Point(65.0, 50.0), rectangle().centre)
        val right = place(73.0, 50.0) + Offset(12f, 0f)
        drag(right, right + (place(83.0, 50.0) - place(73.0, 50.0)))
        assertEquals(26.0, rectangle().width)
        val top = world.handlesOf(editing.selection).first { it.grip == DragHandle.Turn }.place
        val handle = place(top.x, top.y) - Offset(0f, 40f)
        drag(handle, place(70.0, 50.0) + Offset(-200f, 0f))
        assertEquals(90.0, rectangle().angle)
        tap(WorldTags.undo(WorldTags.EDIT))
        assertEquals(0.0, rectangle().angle)
        tap(WorldTags.redo(WorldTags.EDIT))
        assertEquals(90.0, rectangle().angle)
    }

    @Test
    fun `a thing that was not chosen is chosen and moved in one go`() = onEditor {
        drag(place(40.0, 30.0), place(50.0, 40.0))
        assertEquals(Pose(50.0, 40.0, 0.0), world.start)
        assertEquals(ElementRef(ElementKind.ROBOT, 0), editing.only)
    }

    @Test
    fun `with Several switched on a box chooses all in it, which are grouped, moved and deleted together`() = onEditor {
        put(PaletteItem.DOT, 70.0, 60.0)
        put(PaletteItem.DOT, 86.0, 60.0)
        make(WorldEdit.Select(null))
        tap(WorldTags.EDIT_SEVERAL)
        drag(place(60.0, 70.0), place(95.0, 50.0))
        assertEquals(setOf(ElementRef(ElementKind.MARK, 0), ElementRef(ElementKind.MARK, 1)), editing.selection)
        tap(WorldTags.GROUP)
        tap(WorldTags.EDIT_SEVERAL)
        make(WorldEdit.Select(null))
        drag(place(70.0, 60.0), place(70.0, 55.0))
        assertEquals(
            listOf(55.0, 55.0),
            world.marks.map {
                ((it.figure as MarkFigure.Area).shape as Shape.Circle).centre.y
            },
        )
        tap(WorldTags.DUPLICATE)
        assertEquals(4, world.marks.size)
        tap(WorldTags.DELETE)
        assertEquals(2, world.marks.size)
    }

    @Test
    fun `a finger on empty paper moves the sheet and changes nothing, and two fingers zoom`() = onEditor {
        val before = world
        drag(place(80.0, 60.0), place(60.0, 60.0))
        assertEquals(before, world)
        val from = place(60.0, 60.0)
        screen.onNodeWithTag(WorldTags.EDIT_SHEET).performTouchInput {
            down(0, from)
            down(1, from + Offset(40f, 0f))
            for (step in 1..5) {
                moveTo(0, from - Offset(20f * step, 0f))
                moveTo(1, from + Offset(40f + 20f * step, 0f))
            }
            up(0)
            up(1)
        }
        screen.pass(100)
        assertEquals(before, world)
        assertEquals(emptySet(), editing.selection)
    }

    @Test
    fun `a line to be traced is drawn by finger`() = onEditor {
        make(WorldEdit.SelectTool(Tool.DRAW_TEMPLATE))
        drag(place(20.0, 70.0), place(80.0, 70.0))
        val stroke = checkNotNull(world.template).strokes.single()
        assertTrue(stroke.first().x < 22 && stroke.last().x > 78 && stroke.size <= 3, "$stroke")
    }

    @Test
    fun `what has to be mended is told and Done waits for it`() = onEditor {
        put(PaletteItem.WALL, 80.0, 60.0)
        make(WorldEdit.Nudge(-40.0, -30.0))
        assertTrue(isThere(WorldTags.EDIT_HINTS))
        tap(WorldTags.done(WorldTags.EDIT))
        assertNotEquals(null, workshop.state.worldEdit)
        assertTrue(checkNotNull(workshop.state.worldEdit).hasFailedToClose)
        assertEquals(ElementRef(ElementKind.ROBOT, 0), editing.only)
        assertTrue(isThere(WorldTags.CHOSEN_TROUBLE))
        make(WorldEdit.Nudge(0.0, 20.0))
        assertFalse(isThere(WorldTags.EDIT_HINTS))
        tap(WorldTags.done(WorldTags.EDIT))
        assertEquals(null, workshop.state.worldEdit)
    }

    @Test
    fun `a goal and a wall that are touched in the palette lie apart from each other and from the robot`() = onEditor {
        val edges = world.walls.size
        tap(WorldTags.palette(PaletteItem.GOAL_AREA))
        tap(WorldTags.palette(PaletteItem.WALL))
        tap(WorldTags.palette(PaletteItem.GOAL_AREA))
        val inside = world.things().filter { it.kind != ElementKind.WALL || it.number >= edges }
        val boxes = inside.mapNotNull { world.piece(it)?.form?.bounds }
        assertEquals(4, boxes.size)
        for (one in boxes) {
            for (other in boxes - one) {
                val apart =
                    one.right <= other.left || other.right <= one.left || one.top <= other.bottom ||
                        other.top <= one.bottom
                assertTrue(apart, "$one lies over $other")
            }
        }
    }

    @Test
    fun `a goal over the robot is told without keeping the editor open`() = onEditor {
        put(PaletteItem.GOAL_AREA, 40.0, 30.0)
        assertTrue(isThere(WorldTags.EDIT_HINTS))
        tap(WorldTags.done(WorldTags.EDIT))
        assertEquals(null, workshop.state.worldEdit)
    }

    @Test
    fun `what can be kept is kept at once, and discarding brings the old world back`() = onEditor {
        put(PaletteItem.LAMP, 80.0, 60.0)
        assertEquals(1, workshop.project.world.lamps.size)
        make(WorldEdit.Undo)
        put(PaletteItem.LAMP, 70.0, 60.0)
        tap(WorldTags.EDIT_MENU)
        tap(WorldTags.MENU_DISCARD)
        assertEquals(null, workshop.state.worldEdit)
        assertEquals(BuiltInWorlds.plain, workshop.project.world)
    }

    @Test
    fun `Try it closes the editor and the program runs in the new world`() = onEditor {
        put(PaletteItem.DOT, 80.0, 60.0)
        tap(WorldTags.EDIT_TRY)
        screen.pass(1500)
        assertEquals(null, workshop.state.worldEdit)
        assertTrue(workshop.state.running)
        assertEquals(1, workshop.state.world.marks.size)
    }

    @Test
    fun `who comes back can still undo`() = onEditor {
        put(PaletteItem.DOT, 80.0, 60.0)
        tap(WorldTags.done(WorldTags.EDIT))
        workshop.handle(WorldEditEvent.EditorOpened)
        screen.pass(100)
        tap(WorldTags.undo(WorldTags.EDIT))
        assertEquals(0, world.marks.size)
    }

    @Test
    fun `everything that can be pressed is large enough for a finger`() = onEditor {
        put(PaletteItem.DOT, 80.0, 60.0)
        val tags =
            listOf(
                WorldTags.undo(WorldTags.EDIT),
                WorldTags.redo(WorldTags.EDIT),
                WorldTags.EDIT_SEVERAL,
                WorldTags.EDIT_MENU,
                WorldTags.EDIT_TRY,
                WorldTags.done(WorldTags.EDIT),
                WorldTags.palette(PaletteItem.WALL),
                WorldTags.DELETE,
            )
        for (tag in tags + listOf(WorldTags.editTab(EditTab.CHOSEN), WorldTags.editTab(EditTab.WORLD))) {
            val size = screen.onNodeWithTag(tag).fetchSemanticsNode().touchBoundsInRoot
            assertTrue(size.width >= 48f && size.height >= 48f, "$tag is only ${size.size}")
        }
    }

    private fun EditorTest.rectangle() = world.barriers.single().shape as Shape.Rectangle
}
