package robotran.worldediting

import robotran.world.WorldLimits
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class AddingTest {
    @Test
    fun `everything in the palette can be put on a sheet and is chosen and the world can be kept`() {
        for (item in PaletteItem.entries) {
            val put = emptySheet().with(item, 80.0, 45.0)
            assertEquals(item.piece(put.world).kind, put.only?.kind)
            assertNear(Point(80.0, 45.0), put.chosenForm.bounds.middle)
            put.assertSound()
        }
    }

    @Test
    fun `one of each on one sheet can be kept, wherever they are put`() {
        val full = PaletteItem.entries.fold(emptySheet()) { now, item ->
            now.after(WorldEdit.Put(item.piece(now.world), Point(60.0, 45.0)))
        }
        assertEquals(PaletteItem.entries.size + 1, full.world.things().size)
        full.assertSound()
    }

    @Test
    fun `what stands makes room for a robot and what lies does not cover another just like it`() {
        val wall = emptySheet().with(PaletteItem.WALL, 30.0, 45.0)
        assertEquals(emptyList(), wall.errors)
        val areas = emptySheet().with(PaletteItem.AREA, 60.0, 45.0).with(PaletteItem.AREA, 60.0, 45.0)
        assertNotEquals(areas.world.marks[0].figure, areas.world.marks[1].figure)
    }

    @Test
    fun `each new robot has a colour and a name of its own`() {
        val robots = (1..7).fold(emptySheet()) { now, _ ->
            now.after(WorldEdit.Put(PaletteItem.ROBOT.piece(now.world), Point(60.0, 45.0)))
        }
        assertEquals(8, robots.world.robots.map { it.colour }.toSet().size)
        assertEquals(8, robots.world.robots.map { it.name }.toSet().size)
        val ninth = robots.after(WorldEdit.Put(PaletteItem.ROBOT.piece(robots.world), Point(60.0, 45.0)))
        assertEquals(WorldEditError.TooMany(ElementKind.ROBOT), ninth.error)
        assertEquals(robots.world, ninth.world)
        assertEquals(null, ninth.after(WorldEdit.SelectAll).error)
    }

    @Test
    fun `no more lamps than a world can have`() {
        val lamps = (1..WorldLimits.MAXIMUM_LAMPS + 3).fold(emptySheet()) { now, _ ->
            now.after(WorldEdit.Put(PaletteItem.LAMP.piece(now.world), Point(60.0, 45.0)))
        }
        assertEquals(WorldLimits.MAXIMUM_LAMPS, lamps.world.lamps.size)
        lamps.assertSound()
    }

    @Test
    fun `a line drawn by hand keeps its corners and not much else`() {
        val points = (0..40).map { Point(it * 1.0, 5.0) } + (1..20).map { Point(40.0, 5.0 + it) }
        val drawn = emptySheet().after(WorldEdit.SelectTool(Tool.DRAW_TEMPLATE), WorldEdit.Draw(points))
        assertEquals(listOf(listOf(Point(0.0, 5.0), Point(40.0, 5.0), Point(40.0, 25.0))), drawn.world.strokes)
        val line = drawn.after(WorldEdit.SelectTool(Tool.DRAW_LINE), WorldEdit.Draw(points))
        assertEquals(1, line.world.marks.size)
        line.assertSound()
    }

    @Test
    fun `a point is no line`() {
        val drawn = emptySheet().after(
            WorldEdit.SelectTool(Tool.DRAW_TEMPLATE),
            WorldEdit.Draw(
                List(5) {
                    Point(3.0, 3.0)
                },
            ),
        )
        assertEquals(null, drawn.world.template)
    }

    @Test
    fun `a copy has a name of its own and lies beside what it was made of`() {
        val block = emptySheet().with(PaletteItem.BLOCK, 80.0, 45.0)
        val named = block.after(WorldEdit.Change(checkNotNull(block.only), block.chosenPiece.named("box")))
        val two = named.after(WorldEdit.Duplicate)
        assertEquals(listOf("box", "box 2"), two.world.blocks.map { it.name })
        assertEquals(setOf(ElementRef(ElementKind.BLOCK, 1)), two.selection)
        assertNear(Point(83.0, 42.0), two.chosenForm.middle)
        val pasted = two.after(WorldEdit.Copy, WorldEdit.Paste(Point(60.0, 20.0)))
        assertNear(Point(60.0, 20.0), pasted.chosenForm.middle)
        assertEquals("box 3", pasted.world.blocks.last().name)
        assertTrue(two.after(WorldEdit.Select(null), WorldEdit.Copy).clipboard.isEmpty())
        pasted.assertSound()
    }

    @Test
    fun `what is put by a touch lies apart from the robot and from all that is there`() {
        val middle = Point(30.0, 45.0)
        val items = PaletteItem.entries - PaletteItem.PERMITTED_AREA
        val full = items.fold(emptySheet()) { now, item ->
            now.after(WorldEdit.Put(item.piece(now.world), middle, SHEET))
        }
        val areas = full.world.things().map { it to checkNotNull(full.world.piece(it)?.form).bounds }
        for ((one, its) in areas) {
            assertTrue(
                its.left >= 0 && its.right <= 120 && its.bottom >= 0 && its.top <= 90,
                "$one is beside the paper",
            )
            for ((other, others) in areas) assertTrue(one == other || !meet(its, others), "$one lies over $other")
        }
        assertEquals(emptyList(), goalsMetAtStart(full.world))
        full.assertSound()
    }

    @Test
    fun `what is put by a touch stays in sight if there is room, even if there is more elsewhere`() {
        val seen = Bounds(10.0, 40.0, 60.0, 90.0)
        val goal = PaletteItem.GOAL_AREA.piece(newWorld("Test"))
        val put = emptySheet().after(WorldEdit.Put(goal, Point(30.0, 45.0), SHEET)).chosenForm.bounds
        val close = emptySheet().after(WorldEdit.Put(goal, Point(30.0, 45.0), seen)).chosenForm.bounds
        assertTrue(close in seen, "$close")
        assertFalse(put in seen, "$put is in sight, too")
    }

    @Test
    fun `what is put by a touch lies in the middle if that is free, and a permitted area around the robot`() {
        val wall = emptySheet().after(
            WorldEdit.Put(PaletteItem.WALL.piece(newWorld("Test")), Point(80.0, 45.0), SHEET),
        )
        assertTrue(wall.chosenForm.bounds.contains(80.0, 45.0))
        val area = PaletteItem.PERMITTED_AREA.piece(wall.world)
        assertTrue(
            wall.after(WorldEdit.Put(area, Point(30.0, 45.0), SHEET)).chosenForm.bounds.contains(30.0, 45.0),
        )
    }

    private companion object {
        /** All of it. */
        val SHEET = Bounds(0.0, 0.0, 120.0, 90.0)
    }
}
