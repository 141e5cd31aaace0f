package robotran.ui.world

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertContentDescriptionContains
import androidx.compose.ui.test.assertIsOff
import androidx.compose.ui.test.assertIsOn
import androidx.compose.ui.test.click
import androidx.compose.ui.test.doubleClick
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pinch
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.requestFocus
import androidx.compose.ui.test.swipe
import robotran.scene3d.model.Heights
import robotran.simulation.SessionInput
import robotran.ui.world.tags.WorldTags
import robotran.workshop.event.SheetEvent
import robotran.workshop.state.CameraKind
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetElementKind
import robotran.workshop.state.SheetLayer
import robotran.workshop.state.SpaceCamera
import robotran.worldediting.ElementKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class TouchableSpaceTest {
    @Test
    fun `one touch leads to the 3D view and one back, with the same selection and layers`() = onSheet {
        workshop.handle(SheetEvent.ElementChosen(SheetElement(SheetElementKind.ROBOT, 1)))
        workshop.handle(SheetEvent.LayerSwitched(SheetLayer.NAMES, true))
        val before = workshop.state.sheet
        onNodeWithTag(WorldTags.SHEET_3D).assertIsOff()
        onNodeWithTag(WorldTags.SHEET_3D).performClick()
        settle()
        onNodeWithTag(WorldTags.SHEET_3D).assertIsOn()
        assertTrue(workshop.state.sheet.isIn3D)
        onNodeWithTag(WorldTags.SHEET_3D).performClick()
        settle()
        assertEquals(before, workshop.state.sheet)
    }

    @Test
    fun `a finger on empty paper goes around it`() = onSpace {
        val place = at(50.0, 60.0)
        sheet.performTouchInput { swipe(place, place + Offset(100f, -60f), 200) }
        settle()
        assertEquals(SpaceCamera.HEADING - 35, camera.heading, 6.0)
        assertTrue(camera.pitch < SpaceCamera.PITCH - 10, "looks down by ${camera.pitch}")
        assertEquals(emptyList(), touches())
    }

    @Test
    fun `two fingers look from nearer and push the paper`() = onSpace {
        val between = at(50.0, 60.0)
        sheet.performTouchInput {
            pinch(
                between - Offset(30f, 0f),
                between + Offset(20f, 40f) - Offset(75f, 0f),
                between + Offset(30f, 0f),
                between + Offset(20f, 40f) + Offset(75f, 0f),
                300,
            )
        }
        settle()
        assertTrue(camera.zoom in 1.7..3.0, "zoomed to ${camera.zoom}")
        val centre = assertNotNull(camera.centre)
        assertTrue(centre.y > 41, "the paper was pulled down, but the middle is at $centre")
    }

    @Test
    fun `wheel and double tap zoom, and a button shows all of the paper again`() = onSpace {
        val place = at(50.0, 60.0)
        sheet.performMouseInput {
            moveTo(place)
            scroll(-3f)
        }
        settle()
        assertTrue(camera.zoom > 1.2, "zoomed to ${camera.zoom}")
        onNodeWithTag(WorldTags.SHEET_WHOLE).performClick()
        settle()
        assertEquals(SpaceCamera(), camera)
        sheet.performTouchInput { doubleClick(at(50.0, 60.0)) }
        settle()
        assertEquals(2.0, camera.zoom)
    }

    @Test
    fun `keys go around the paper and zoom`() = onSpace {
        sheet.requestFocus()
        sheet.performKeyInput {
            pressKey(Key.DirectionRight)
            pressKey(Key.DirectionUp)
            pressKey(Key.Plus)
        }
        settle()
        assertEquals(SpaceCamera.HEADING + 15, camera.heading)
        assertEquals(SpaceCamera.PITCH + 6, camera.pitch)
        assertEquals(1.3, camera.zoom)
        sheet.performKeyInput { pressKey(Key.Zero) }
        settle()
        assertEquals(SpaceCamera(), camera)
    }

    @Test
    fun `a finger takes the robot by its brick, and it follows the finger`() = onSpace {
        // The brick is five centimetres in front of the pen.
        val from = at(35.0, 40.0, 8.0)
        val to = at(55.0, 60.0, 8.0)
        sheet.performTouchInput { swipe(from, to, 160) }
        settle()
        val pose = workshop.state.session.robot.pose
        assertEquals(50.0, pose.x, 0.4)
        assertEquals(60.0, pose.y, 0.4)
        assertEquals(SheetElement(SheetElementKind.ROBOT, 0), workshop.state.sheet.chosen)
        assertTrue(touches().all { it is SessionInput.PlaceRobot }, "${touches()}")
        assertEquals(SpaceCamera(), camera)
    }

    @Test
    fun `a robot that was tapped is turned by its handle on the paper`() = onSpace {
        val robot = SheetElement(SheetElementKind.ROBOT, 0)
        sheet.performTouchInput { click(at(35.0, 40.0, 8.0)) }
        settle()
        assertEquals(robot, workshop.state.sheet.chosen)
        val handle = assertNotNull(handleOf(robot, handyWorld, workshop.state.session))
        sheet.performTouchInput { swipe(at(handle.x, handle.y), at(30.0, 54.0), 160) }
        settle()
        assertEquals(90.0, workshop.state.session.robot.pose.heading, 2.0)
        sheet.performTouchInput { click(at(55.0, 70.0)) }
        settle()
        assertNull(workshop.state.sheet.chosen)
    }

    @Test
    fun `a tap on its shade switches a lamp, and a finger moves it`() = onSpace {
        sheet.performTouchInput { click(at(20.0, 70.0, Heights.LAMP + 0.5)) }
        settle()
        assertEquals(false, workshop.state.session.lamps.single().on)
        sheet.performTouchInput {
            swipe(at(20.0, 70.0, Heights.LAMP + 0.5), at(40.0, 60.0, Heights.LAMP + 0.5), 160)
        }
        settle()
        assertEquals(40.0, workshop.state.session.lamps.single().place.x, 2.0)
        assertEquals(60.0, workshop.state.session.lamps.single().place.y, 2.0)
    }

    @Test
    fun `a finger pushes a block by its top`() = onSpace {
        sheet.performTouchInput { swipe(at(60.0, 30.0, Heights.BLOCK), at(70.0, 40.0, Heights.BLOCK), 160) }
        settle()
        assertEquals(10.0, workshop.state.session.blocks.single().x, 0.4)
        assertEquals(10.0, workshop.state.session.blocks.single().y, 0.4)
    }

    @Test
    fun `keys move and turn what has the focus, and readers hear the same as on the sheet`() = onSpace {
        onNodeWithTag(WorldTags.thing(ElementKind.ROBOT, 0)).requestFocus()
        settle()
        onNodeWithTag(WorldTags.thing(ElementKind.ROBOT, 0)).performKeyInput {
            pressKey(Key.DirectionRight)
            pressKey(Key.LeftBracket)
        }
        settle()
        val pose = workshop.state.session.robot.pose
        assertEquals(31.0, pose.x, 1e-6)
        assertEquals(15.0, pose.heading, 1e-6)
        sheet.assertContentDescriptionContains("Place to reach: 90.0 cm across and 20.0 cm up", substring = true)
        onNodeWithTag(WorldTags.thing(ElementKind.BLOCK, 0))
            .assertContentDescriptionContains("Block 1, 60.0 cm across", substring = true)
    }

    @Test
    fun `the camera is chosen from a list, which a reader hears`() = onSpace {
        workshop.handle(SheetEvent.ElementChosen(SheetElement(SheetElementKind.ROBOT, 1)))
        for (kind in listOf(CameraKind.FOLLOW, CameraKind.ROBOT_EYE, CameraKind.ORBIT)) {
            onNodeWithTag(WorldTags.SHEET_SHOW).performClick()
            settle()
            onNodeWithTag(WorldTags.camera(kind)).performClick()
            settle()
            assertEquals(kind, workshop.state.sheet.cameraKind)
            assertEquals(1, camera.robot)
        }
        val said = sheet.fetchSemanticsNode().config[SemanticsProperties.StateDescription]
        assertEquals("From around the paper", said)
    }

    private fun SpaceOnScreen.touches(): List<SessionInput> =
        workshop.inputs.map { it.input }.filterNot { it is SessionInput.Press || it is SessionInput.Release }
}
