package robotran.ui.worldedit

import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.text.TextLayoutResult
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.pass
import robotran.ui.world.tags.WorldTags
import robotran.uikit.KitTags
import robotran.world.GoalCondition.InOrder
import robotran.world.GoalCondition.Reach
import robotran.world.LightFacing
import robotran.world.MarkFigure
import robotran.world.RobotColour
import robotran.world.Shade
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.PaletteItem
import robotran.worldediting.Tool
import robotran.worldediting.WorldEdit
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class EditPanelTest {
    @Test
    fun `on a tablet held upright the paper has the width of the screen, and the panel lies under it`() =
        onEditor(820, 1180) {
            put(PaletteItem.BLOCK, 75.0, 60.0)
            val sheet = boundsOf(WorldTags.EDIT_SHEET)
            val panel = boundsOf(WorldTags.EDIT_PANEL)
            assertTrue(sheet.width > 650f && sheet.height > 500f, "$sheet")
            assertTrue(panel.top >= sheet.bottom && panel.width == 820f, "$panel under $sheet")
            tap(WorldTags.DELETE)
            assertEquals(emptyList(), world.blocks)
        }

    @Test
    fun `figures can be typed and stepped, and what cannot be is told and not taken`() = onEditor(1280, 2400) {
        put(PaletteItem.BLOCK, 75.0, 60.0)
        type("field-mass", "0,25")
        assertEquals(0.25, world.blocks[0].mass)
        type("field-x", "50")
        type("field-width", "9")
        tap("field-y-more")
        val rectangle = world.blocks[0].shape as Shape.Rectangle
        assertEquals(Point(50.0, 61.0), rectangle.centre)
        assertEquals(9.0, rectangle.width)
        type("field-friction", "11")
        assertEquals(0.3, world.blocks[0].friction)
        type("field-name", "crate")
        assertEquals("crate", world.blocks[0].name)
        type("field-name", "yellow")
        assertEquals("crate", world.blocks[0].name)
    }

    @Test
    fun `a number with two decimal places is whole in its field`() = onEditor(1280, 2400) {
        put(PaletteItem.BLOCK, 75.0, 60.0)
        type("field-x", "118.75")
        val field = screen.onNodeWithTag("field-x").fetchSemanticsNode()
        val layouts = mutableListOf<TextLayoutResult>()
        field.config[SemanticsActions.GetTextLayoutResult].action?.invoke(layouts)
        val width = layouts.single().multiParagraph.maxIntrinsicWidth
        assertTrue(width <= field.size.width, "$width in ${field.size.width}")
    }

    @Test
    fun `a robot gets a colour, a name, a light sensor that looks ahead, ports and a program`() = onEditor(1280, 2400) {
        tap(WorldTags.palette(PaletteItem.ROBOT))
        assertEquals(RobotColour.RED, world.robots[1].colour)
        tap(ProgramTags.robot("colour-3"))
        tap("facing-2")
        tap("port-2-0")
        tap("port-2-0-0")
        tap("field-has-program")
        type("field-beacon", "2")
        val robot = world.robots[1]
        assertEquals(RobotColour.GREEN, robot.colour)
        assertEquals(LightFacing.FORWARD, robot.lightFacing)
        assertEquals(emptyList(), robot.ports[1])
        assertEquals(2.0, robot.beacon)
        assertTrue(robot.program.orEmpty().contains("forward"))
    }

    @Test
    fun `marks get swatches, greys and any colour, and their order`() = onEditor(1280, 2400) {
        put(PaletteItem.AREA, 75.0, 60.0)
        put(PaletteItem.LINE, 75.0, 60.0)
        tap("shade-8")
        assertEquals(Shade.Colour(17, 51, 170), world.marks[1].shade)
        type("field-green", "99")
        assertEquals(Shade.Colour(17, 99, 170), world.marks[1].shade)
        tap("shade-1")
        type("field-grey", "0.45")
        assertEquals(Shade.Grey(0.45), world.marks[1].shade)
        tap("field-closed")
        type("field-thickness", "3")
        assertEquals(3.0, (world.marks[1].figure as MarkFigure.Line).width)
        assertTrue((world.marks[1].figure as MarkFigure.Line).closed)
        tap("add-corner")
        assertEquals(4, (world.marks[1].figure as MarkFigure.Line).points.size)
        tap(WorldTags.TO_BACK)
        assertTrue(world.marks[0].figure is MarkFigure.Line)
    }

    @Test
    fun `lamps get brightness, a cone and a direction and can be off`() = onEditor(1280, 2400) {
        put(PaletteItem.LAMP, 75.0, 60.0)
        tap("field-on")
        type("field-brightness", "4")
        type("field-cone", "60")
        type("field-angle", "200")
        val lamp = world.lamps[0]
        assertEquals(listOf(4.0, 60.0, -160.0), listOf(lamp.brightness, lamp.cone, lamp.direction))
        assertEquals(false, lamp.on)
    }

    @Test
    fun `the world as a whole can be changed and begun anew`() = onEditor(1280, 2400) {
        tap(WorldTags.editTab(EditTab.WORLD))
        type("field-title", "A yard")
        type("field-task", "Drive.")
        type("field-paper-width", "150")
        type("field-light", "0.1")
        type("field-temperature", "-5")
        type("field-time-limit", "30")
        type("field-realism", "50")
        type("field-seed", "7")
        assertEquals(
            listOf<Any>("A yard", "Drive.", 150.0, 0.1, -5.0, 30, 0.5, 7),
            with(world) {
                listOf(title, task, paper.width, ambientLight, temperature, timeLimit, realism, seed)
            },
        )
        tap(WorldTags.NEW_WORLD)
        assertEquals("My world", world.title)
        assertEquals(0, world.walls.size)
    }

    @Test
    fun `goals of every kind are added from the list, put in groups and changed`() = onEditor(1280, 2400) {
        put(PaletteItem.LINE, 75.0, 60.0)
        make(WorldEdit.SelectTool(Tool.DRAW_TEMPLATE))
        make(WorldEdit.Draw(listOf(Point(10.0, 10.0), Point(30.0, 10.0))))
        make(WorldEdit.SelectTool(Tool.SELECT))
        tap(WorldTags.editTab(EditTab.GOALS))
        for (kind in 0..12) {
            make(WorldEdit.Select(null))
            tap(WorldTags.ADD_GOAL)
            tap(KitTags.at(WorldTags.ADD_GOAL, kind))
        }
        assertEquals(13, world.goals.map { it.condition::class }.toSet().size)
        assertEquals(emptyList(), editing.errors)
        tap(WorldTags.thing(ElementKind.GOAL, 0))
        tap(WorldTags.GOAL_DOWN)
        assertTrue(world.goals[1].condition is Reach)
        tap(WorldTags.GOAL_WRAP)
        tap(KitTags.at(WorldTags.GOAL_WRAP, 0))
        assertTrue(world.goals[1].condition is InOrder)
        tap(WorldTags.GOAL_CHANGE)
        tap("field-stays")
        tap("field-within")
        type("field-seconds", "12")
        val reach = world.goals[1].parts.single().condition as Reach
        assertEquals(true to 12, reach.stays to reach.within)
    }

    @Test
    fun `everything on the sheet is in the list of things by its name`() = onEditor(1280, 2400) {
        tap(WorldTags.editTab(EditTab.THINGS))
        tap(WorldTags.thing(ElementKind.WALL, 2))
        assertEquals(ElementRef(ElementKind.WALL, 2), editing.only)
        screen.onNodeWithTag(WorldTags.CHOSEN_NAME).fetchSemanticsNode()
    }

    @Test
    fun `on a phone the panel comes up under the sheet`() = onEditor(411, 891) {
        tap(WorldTags.palette(PaletteItem.WALL))
        tap(WorldTags.editTab(EditTab.CHOSEN))
        assertTrue(isThere(WorldTags.EDIT_PANEL))
        tap(WorldTags.TURN_LEFT)
        tap(WorldTags.editTab(EditTab.CHOSEN))
        assertTrue(!isThere(WorldTags.EDIT_PANEL))
    }

    private fun EditorTest.type(tag: String, text: String) {
        screen.onNodeWithTag(tag).performTextReplacement(text)
        screen.pass(60)
    }
}
