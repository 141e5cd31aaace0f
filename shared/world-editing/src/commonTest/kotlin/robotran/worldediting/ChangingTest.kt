package robotran.worldediting

import kotlinx.serialization.json.JsonPrimitive
import robotran.language.Language
import robotran.language.history.History
import robotran.world.UnknownFields
import robotran.world.file.BuiltInWorlds
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class ChangingTest {
    @Test
    fun `typing a title is one step until it is settled`() {
        val parameters = emptySheet().world.parameters
        val typed = emptySheet().after(
            WorldEdit.ChangeSheet(parameters.copy(title = "A")),
            WorldEdit.ChangeSheet(parameters.copy(title = "Ab")),
            WorldEdit.FinishChange,
            WorldEdit.ChangeSheet(parameters.copy(title = "Ab", seed = 7)),
        )
        assertEquals(2, typed.history.past.size)
        val undone = typed.after(WorldEdit.Undo, WorldEdit.Undo)
        assertEquals("Test", undone.world.title)
        assertEquals(typed.world, undone.after(WorldEdit.Redo, WorldEdit.Redo).world)
    }

    @Test
    fun `what a world cannot be like is refused and changes nothing`() {
        val sheet = emptySheet()
        val parameters = sheet.world.parameters
        val impossible = listOf(
            parameters.copy(title = " "),
            parameters.copy(title = "x".repeat(101)),
            parameters.copy(title = "a\nb"),
            parameters.copy(task = "a\tb"),
            parameters.copy(task = "x".repeat(1001)),
            parameters.copy(width = 19.0),
            parameters.copy(height = 1001.0),
            parameters.copy(ambientLight = -1.0),
            parameters.copy(temperature = 51.0),
            parameters.copy(timeLimit = 0),
            parameters.copy(realism = 1.1),
            parameters.copy(seed = -1),
            parameters.copy(width = Double.NaN),
        )
        for (wanted in impossible) {
            val refused = sheet.after(WorldEdit.ChangeSheet(wanted))
            assertTrue(refused.error != null, "$wanted is taken")
            assertEquals(sheet.world, refused.world)
        }
    }

    @Test
    fun `what is to be done may be told in several lines`() {
        val sheet = emptySheet()
        val described = sheet.after(
            WorldEdit.ChangeSheet(sheet.world.parameters.copy(task = "Drive to the flag.\nThen stop.")),
        )
        assertEquals(null, described.error)
        assertEquals("Drive to the flag.\nThen stop.", described.world.task)
    }

    @Test
    fun `two things cannot be called the same`() {
        val lamp = emptySheet().with(PaletteItem.LAMP, 80.0, 45.0)
        val renamed = lamp.after(WorldEdit.Change(checkNotNull(lamp.only), lamp.chosenPiece.named("yellow")))
        assertEquals(WorldEditError.NameTaken("yellow"), renamed.error)
    }

    @Test
    fun `the last robot stays`() {
        val sheet = emptySheet().after(WorldEdit.SelectAll, WorldEdit.Delete)
        assertEquals(WorldEditError.LastRobot, sheet.error)
        assertEquals(1, sheet.world.robots.size)
    }

    @Test
    fun `a robot in a wall or beside the paper is told of until it is mended, and the paper may still shrink`() {
        val wall = emptySheet().with(PaletteItem.WALL, 80.0, 45.0).after(WorldEdit.Nudge(-50.0, 0.0))
        assertEquals(
            listOf<ValidationError>(
                ValidationError.Obstructed(ElementRef(ElementKind.ROBOT, 0), ElementRef(ElementKind.WALL, 0)),
            ),
            wall.errors,
        )
        wall.after(WorldEdit.Delete).assertSound()
        val narrow = emptySheet().after(WorldEdit.ChangeSheet(emptySheet().world.parameters.copy(width = 25.0)))
        assertEquals(listOf<ValidationError>(ValidationError.OffPaper(ElementRef(ElementKind.ROBOT, 0))), narrow.errors)
    }

    @Test
    fun `what a file says beyond what is known stays with its thing`() {
        val box = emptySheet().with(PaletteItem.BOX, 80.0, 45.0)
        val barrier = (box.chosenPiece as Element.OfBarrier).barrier.copy(
            unknown = UnknownFields(mapOf("paint" to JsonPrimitive("wet"))),
        )
        val marked = box.after(WorldEdit.Change(checkNotNull(box.only), Element.OfBarrier(barrier)))
        val copied = marked.after(
            WorldEdit.Nudge(1.0, 1.0),
            WorldEdit.TurnBy(30.0),
            WorldEdit.MakeCorners(checkNotNull(marked.only)),
            WorldEdit.Duplicate,
        )
        assertEquals(List(2) { barrier.unknown }, copied.world.barriers.map { it.unknown })
        copied.assertSound()
    }

    @Test
    fun `several edits together are one step or nothing`() {
        val box = emptySheet().with(PaletteItem.BOX, 80.0, 45.0)
        val moved = box.after(WorldEdit.Batch(listOf(WorldEdit.Nudge(1.0, 0.0), WorldEdit.TurnBy(15.0))))
        assertEquals(box.history.past.size + 1, moved.history.past.size)
        assertEquals(box.world, moved.after(WorldEdit.Undo).world)
        val refused = box.after(WorldEdit.Batch(listOf(WorldEdit.Nudge(1.0, 0.0), WorldEdit.Nudge(1e7, 0.0))))
        assertEquals(box.world, refused.world)
        assertEquals(WorldEditError.TooFar, refused.error)
    }

    @Test
    fun `a new world has nothing but a robot, and undoing brings the old one back`() {
        val old = emptySheet().with(PaletteItem.BOX, 80.0, 45.0)
        val new = old.after(WorldEdit.NewWorld("Fresh"))
        assertEquals(listOf(ElementRef(ElementKind.ROBOT, 0)), new.world.things())
        new.assertSound()
        assertEquals(old.world, new.after(WorldEdit.Undo).world)
    }

    @Test
    fun `every world that comes with Robotran can be opened, moved as a whole and kept`() {
        for ((name, text) in BuiltInWorlds.texts) {
            val editing = WorldEditing.of((readWorld(text, Language.ENGLISH) as WorldFileResult.Success).world)
            assertEquals(emptyList(), editing.errors, name)
            val moved = editing.after(WorldEdit.SelectAll, WorldEdit.Nudge(1.0, 1.0), WorldEdit.Select(null))
            moved.assertSound()
            assertEquals(editing.world, moved.after(WorldEdit.Undo).world)
        }
    }

    @Test
    fun `undoing goes back at most so many steps`() {
        val moved = (1..History.MAX_STEPS + 20).fold(
            emptySheet().after(WorldEdit.Select(ElementRef(ElementKind.ROBOT, 0))),
        ) { now, number ->
            now.after(WorldEdit.Nudge(if (number % 2 == 0) 1.0 else -1.0, 0.0))
        }
        assertEquals(History.MAX_STEPS, moved.history.past.size)
    }

    @Test
    fun `the place of a tap is exact enough for small things`() {
        val stroke = emptySheet().with(PaletteItem.TEMPLATE_LINE, 80.0, 45.0).after(WorldEdit.Select(null))
        assertEquals(ElementKind.STROKE, stroke.after(WorldEdit.TapAt(Point(80.0, 46.0), REACH)).only?.kind)
        assertEquals(null, stroke.after(WorldEdit.TapAt(Point(80.0, 47.0), REACH)).only)
    }
}
