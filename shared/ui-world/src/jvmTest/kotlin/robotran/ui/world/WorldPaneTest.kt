package robotran.ui.world

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertContentDescriptionContains
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.assertIsOn
import androidx.compose.ui.test.click
import androidx.compose.ui.test.doubleClick
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pinch
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.requestFocus
import androidx.compose.ui.test.swipe
import androidx.compose.ui.test.withKeyDown
import robotran.simulation.SessionInput
import robotran.ui.world.tags.WorldTags
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetElementKind
import robotran.workshop.state.SheetLayer
import robotran.world.geometry.Pose
import robotran.worldediting.ElementKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class WorldPaneTest {
    @Test
    fun `two fingers look at the sheet from nearer, and what is between them stays there`() = onSheet {
        val between = at(50.0, 20.0)
        sheet.performTouchInput {
            pinch(
                between - Offset(30f, 0f),
                between - Offset(90f, 0f),
                between + Offset(30f, 0f),
                between + Offset(90f, 0f),
                300,
            )
        }
        settle()
        assertTrue(camera.zoom in 2.0..3.5, "zoomed to ${camera.zoom}")
        val after = view.toCentimetres(between)
        assertEquals(50.0, after.x, 3.0)
        assertEquals(20.0, after.y, 3.0)
    }

    @Test
    fun `a finger on empty paper pushes the sheet when it is near`() = onSheet {
        sheet.performTouchInput { doubleClick(at(50.0, 60.0)) }
        settle()
        assertEquals(2.0, camera.zoom)
        val before = view
        sheet.performTouchInput { swipe(center + Offset(40f, 60f), center + Offset(140f, 10f), 200) }
        settle()
        assertEquals(before.paper.left + 100f, view.paper.left, 20f)
        assertEquals(before.paper.top - 50f, view.paper.top, 20f)
        assertEquals(emptyList(), touches())
    }

    @Test
    fun `the wheel zooms about the pointer`() = onSheet {
        val place = at(70.0, 40.0)
        sheet.performMouseInput {
            moveTo(place)
            scroll(-3f)
        }
        settle()
        assertTrue(camera.zoom > 1.2, "zoomed to ${camera.zoom}")
        assertEquals(70.0, view.toCentimetres(place).x, 0.1)
        onNodeWithTag(WorldTags.SHEET_WHOLE).performClick()
        settle()
        assertEquals(1.0, camera.zoom)
    }

    @Test
    fun `the buttons zoom in and out as far as it goes`() = onSheet {
        onNodeWithTag(WorldTags.SHEET_FURTHER).assertIsNotEnabled()
        repeat(3) { onNodeWithTag(WorldTags.SHEET_NEARER).performClick() }
        settle()
        assertEquals(2.197, camera.zoom, 1e-6)
        repeat(3) {
            onNodeWithTag(WorldTags.SHEET_FURTHER).performClick()
            settle()
        }
        assertEquals(1.0, camera.zoom, 1e-6)
    }

    @Test
    fun `the keys plus, minus, nought and the arrows look around`() = onSheet {
        sheet.requestFocus()
        sheet.performKeyInput { repeat(4) { pressKey(Key.Plus) } }
        settle()
        assertEquals(2.8561, camera.zoom, 1e-6)
        val before = view.paper
        sheet.performKeyInput { pressKey(Key.DirectionRight) }
        settle()
        assertEquals(before.left - 60f, view.paper.left, 0.5f)
        sheet.performKeyInput { pressKey(Key.Minus) }
        settle()
        assertEquals(2.197, camera.zoom, 1e-6)
        sheet.performKeyInput { pressKey(Key.Zero) }
        settle()
        assertEquals(1.0, camera.zoom)
    }

    @Test
    fun `a robot that is followed stays in the middle until the sheet is pushed`() = onSheet {
        onNodeWithTag(WorldTags.SHEET_SHOW).performClick()
        settle()
        onNodeWithTag(WorldTags.SHEET_FOLLOW).performClick()
        settle()
        onNodeWithTag(WorldTags.SHEET_SHOW).performClick()
        settle()
        onNodeWithTag(WorldTags.SHEET_FOLLOW).assertIsOn()
        onNodeWithTag(WorldTags.SHEET_FOLLOW).performKeyInput { pressKey(Key.Escape) }
        settle()
        assertEquals(0, workshop.state.sheet.followed)
        assertEquals(2.5, camera.zoom)
        sheet.performTouchInput { swipe(center + Offset(0f, 240f), center + Offset(80f, 240f), 200) }
        settle()
        assertNull(workshop.state.sheet.followed)
        val centre = assertNotNull(camera.centre)
        assertTrue(centre.x < 45, "the middle is at $centre")
    }

    @Test
    fun `a finger drags the robot, one place for each frame at most, and that is recorded`() = onSheet {
        val from = at(32.0, 40.0)
        val to = at(52.0, 60.0)
        sheet.performTouchInput { swipe(from, to, 160) }
        settle()
        val pose = workshop.state.session.robot.pose
        assertEquals(50.0, pose.x, 0.2)
        assertEquals(60.0, pose.y, 0.2)
        assertEquals(0.0, pose.heading, 1e-6)
        val inputs = touches()
        assertTrue(
            inputs.all {
                it is SessionInput.PlaceRobot && it.robot == 0
            } && inputs.size in 2..14,
            inputs.toString(),
        )
        assertEquals(SheetElement(SheetElementKind.ROBOT, 0), workshop.state.sheet.chosen)
    }

    @Test
    fun `a robot that was tapped is turned by its handle, and a tap beside it puts the handle away`() = onSheet {
        val robot = SheetElement(SheetElementKind.ROBOT, 0)
        sheet.performTouchInput { click(at(30.0, 40.0)) }
        settle()
        assertEquals(robot, workshop.state.sheet.chosen)
        val handle = assertNotNull(handleOf(robot, handyWorld, workshop.state.session))
        sheet.performTouchInput { swipe(at(handle.x, handle.y), at(30.0, 54.0), 160) }
        settle()
        assertEquals(Pose(30.0, 40.0, 90.0), workshop.state.session.robot.pose.rounded())
        sheet.performTouchInput { click(at(50.0, 70.0)) }
        settle()
        assertNull(workshop.state.sheet.chosen)
    }

    @Test
    fun `a tap switches a lamp, and a finger drags it`() = onSheet {
        sheet.performTouchInput { click(at(20.0, 70.0)) }
        settle()
        assertEquals(false, workshop.state.session.lamps.single().on)
        sheet.performTouchInput { swipe(at(20.0, 70.0), at(40.0, 65.0), 160) }
        settle()
        assertEquals(40.0, workshop.state.session.lamps.single().place.x, 0.3)
        sheet.performTouchInput { click(at(40.0, 65.0)) }
        settle()
        assertEquals(true, workshop.state.session.lamps.single().on)
    }

    @Test
    fun `a finger drags a block, which does not come to lie in a barrier`() = onSheet {
        sheet.performTouchInput { swipe(at(60.0, 30.0), at(70.0, 40.0), 160) }
        settle()
        assertEquals(10.0, workshop.state.session.blocks.single().x, 0.3)
        assertEquals(10.0, workshop.state.session.blocks.single().y, 0.3)
        sheet.performTouchInput { swipe(at(70.0, 40.0), at(60.0, 11.0), 160) }
        settle()
        assertTrue(workshop.state.session.blocks.single().y + 30 > 14.9, "the block is in the barrier")
    }

    @Test
    fun `a finger on the robot while another pinches goes on dragging the robot`() = onSheet {
        val from = at(32.0, 40.0)
        val other = at(60.0, 70.0)
        sheet.performTouchInput {
            down(0, from)
            moveTo(0, from + Offset(40f, 0f))
        }
        settle()
        sheet.performTouchInput {
            down(1, other)
            moveTo(1, other + Offset(50f, 50f))
            moveTo(0, from + Offset(60f, 0f))
            up(1)
            up(0)
        }
        settle()
        assertEquals(1.0, camera.zoom)
        assertEquals(30.0 + view.toCentimetres(60f), workshop.state.session.robot.pose.x, 0.3)
    }

    @Test
    fun `keys move and turn what has the focus`() = onSheet {
        onNodeWithTag(WorldTags.thing(ElementKind.ROBOT, 0)).requestFocus()
        settle()
        assertEquals(SheetElement(SheetElementKind.ROBOT, 0), workshop.state.sheet.chosen)
        onNodeWithTag(WorldTags.thing(ElementKind.ROBOT, 0)).performKeyInput {
            pressKey(Key.DirectionRight)
            pressKey(Key.DirectionUp)
            withKeyDown(Key.ShiftLeft) { pressKey(Key.DirectionLeft) }
            pressKey(Key.LeftBracket)
        }
        settle()
        assertEquals(Pose(30.9, 41.0, 15.0), workshop.state.session.robot.pose.rounded())
        onNodeWithTag(WorldTags.thing(ElementKind.BLOCK, 0)).requestFocus()
        onNodeWithTag(WorldTags.thing(ElementKind.BLOCK, 0)).performKeyInput { pressKey(Key.RightBracket) }
        settle()
        assertEquals(Pose(0.0, 0.0, -15.0), workshop.state.session.blocks.single().rounded())
        onNodeWithTag(WorldTags.thing(ElementKind.LAMP, 0)).requestFocus()
        onNodeWithTag(WorldTags.thing(ElementKind.LAMP, 0)).performKeyInput { pressKey(Key.Enter) }
        settle()
        assertEquals(false, workshop.state.session.lamps.single().on)
    }

    @Test
    fun `what is drawn over the sheet is chosen from a list`() = onSheet {
        onNodeWithTag(WorldTags.SHEET_SHOW).performClick()
        settle()
        for (layer in SheetLayer.entries - SheetLayer.GOALS) {
            onNodeWithTag(WorldTags.layer(layer)).performClick()
        }
        settle()
        assertEquals(SheetLayer.entries.toSet(), workshop.state.sheet.shown)
        onNodeWithTag(WorldTags.layer(SheetLayer.GOALS)).performClick()
        settle()
        assertEquals(SheetLayer.entries.toSet() - SheetLayer.GOALS, workshop.state.sheet.shown)
    }

    @Test
    fun `light and warmth are changed by sliders and recorded`() = onSheet {
        onNodeWithTag(WorldTags.SHEET_SURROUNDINGS).performClick()
        settle()
        onNodeWithTag(WorldTags.surroundings(WorldTags.LIGHT)).performSemanticsAction(SemanticsActions.SetProgress) {
            it(2f)
        }
        settle()
        onNodeWithTag(
            WorldTags.surroundings(WorldTags.TEMPERATURE),
        ).performSemanticsAction(SemanticsActions.SetProgress) {
            it(35f)
        }
        settle()
        assertEquals(2.0, workshop.state.session.surroundings.light)
        assertEquals(35.0, workshop.state.session.surroundings.celsius)
        assertEquals(listOf(SessionInput.ChangeAmbientLight(2.0), SessionInput.ChangeTemperature(35.0)), touches())
    }

    @Test
    fun `who cannot see the sheet hears what is where`() = onSheet {
        sheet.assertContentDescriptionContains("yellow: Robot at 30.0 cm across and 40.0 cm up", substring = true)
        sheet.assertContentDescriptionContains("Place to reach: 90.0 cm across and 20.0 cm up", substring = true)
        onNodeWithTag(WorldTags.thing(ElementKind.ROBOT, 1))
            .assertContentDescriptionContains("Robot red, 80.0 cm across and 60.0 cm up, looking 90.0 degrees")
        onNodeWithTag(WorldTags.thing(ElementKind.BLOCK, 0))
            .assertContentDescriptionContains("Block 1, 60.0 cm across", substring = true)
        onNodeWithTag(WorldTags.thing(ElementKind.LAMP, 0))
            .assertContentDescriptionContains("Lamp 1, 20.0 cm across and 70.0 cm up, on")
        onNodeWithTag(WorldTags.thing(ElementKind.LAMP, 0)).performSemanticsAction(SemanticsActions.OnClick)
        settle()
        onNodeWithTag(WorldTags.thing(ElementKind.LAMP, 0)).assertContentDescriptionContains("off", substring = true)
    }

    @Test
    fun `who cannot see the sheet hears which lamp sends infrared light`() =
        onSheet(handyWorld.copy(lamps = handyWorld.lamps.map { it.copy(infrared = true) })) {
            onNodeWithTag(WorldTags.thing(ElementKind.LAMP, 0))
                .assertContentDescriptionContains("infrared light, on", substring = true)
        }

    @Test
    fun `a bump is read out`() {
        val facing = handyWorld.copy(
            robots = handyWorld.robots.take(1),
            barriers = handyWorld.barriers,
            goals = emptyList(),
        )
            .withStart(Pose(45.0, 10.0, 0.0))
        onSheet(facing) {
            onNodeWithTag(WorldTags.BUMP).assertContentDescriptionContains("")
            workshop.handle(robotran.workshop.event.RunEvent.RunPressed)
            pass(2_000)
            onNodeWithTag(WorldTags.BUMP).assertContentDescriptionContains("Bump 1: yellow ran into a barrier")
        }
    }

    @Test
    fun `on a phone there are the buttons that fingers cannot do without`() = onSheet(width = 411, height = 891) {
        for (tag in listOf(WorldTags.SHEET_WHOLE, WorldTags.SHEET_SHOW, WorldTags.SHEET_3D)) {
            val place = onNodeWithTag(tag).fetchSemanticsNode().boundsInRoot
            assertTrue(place.width >= 48f && place.height >= 48f, "$tag is only ${place.size}")
        }
        onNodeWithTag(WorldTags.SHEET_NEARER).assertDoesNotExist()
        val buttons = onNodeWithTag(WorldTags.SHEET_WHOLE).fetchSemanticsNode().boundsInRoot
        val pane = sheet.fetchSemanticsNode().boundsInRoot
        assertTrue(buttons.top > pane.top + view.paper.bottom, "the buttons are over the paper")
    }

    private fun SheetOnScreen.touches(): List<SessionInput> =
        workshop.inputs.map { it.input }.filterNot { it is SessionInput.Press || it is SessionInput.Release }

    private fun Pose.rounded() = Pose(tenths(x), tenths(y), tenths(heading))

    private fun tenths(number: Double) = kotlin.math.round(number * 10) / 10 + 0.0
}
