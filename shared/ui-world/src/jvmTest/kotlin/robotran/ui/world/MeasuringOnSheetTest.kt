package robotran.ui.world

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertContentDescriptionContains
import androidx.compose.ui.test.assertContentDescriptionEquals
import androidx.compose.ui.test.assertIsOff
import androidx.compose.ui.test.assertIsOn
import androidx.compose.ui.test.click
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.requestFocus
import androidx.compose.ui.test.swipe
import androidx.compose.ui.test.withKeyDown
import robotran.ui.world.tags.WorldTags
import robotran.workshop.measuring.Measuring
import robotran.workshop.measuring.MeasuringBase
import robotran.workshop.measuring.MeasuringEnd
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class MeasuringOnSheetTest {
    @Test
    fun `one touch shows how far the goal is and how the robot turns to it, another puts all away`() = onSheet {
        measure()
        onNodeWithTag(WorldTags.SHEET_MEASURE).assertIsOn()
        assertEquals(Point(30.0, 40.0), ruler.from)
        assertEquals(Point(90.0, 20.0), ruler.to)
        onNodeWithTag(WorldTags.MEASURED).assertContentDescriptionEquals("63.2 cm, turn right 18.4 degrees")
        onNodeWithTag(WorldTags.SHEET_MEASURE).performClick()
        settle()
        onNodeWithTag(WorldTags.SHEET_MEASURE).assertIsOff()
        assertNull(workshop.state.sheet.measuring)
        onNodeWithTag(WorldTags.MEASURED).assertDoesNotExist()
    }

    @Test
    fun `a finger measures from point to point`() = onSheet {
        measure()
        sheet.performTouchInput { swipe(at(40.0, 60.0), at(60.0, 75.0), 200) }
        settle()
        assertEquals(25.0, ruler.centimetres, 1.0)
        assertEquals(36.9, ruler.degrees, 2.5)
        assertNothingTouched()
    }

    @Test
    fun `a finger takes an end, which snaps to the things and the robots, and moves none of them`() = onSheet {
        measure()
        sheet.performTouchInput { swipe(at(90.0, 20.0), at(20.6, 69.6), 200) }
        settle()
        assertEquals(Point(20.0, 70.0), ruler.to)
        sheet.performTouchInput { swipe(at(30.0, 40.0), at(80.5, 59.5), 200) }
        settle()
        assertEquals(Point(80.0, 60.0), ruler.from)
        assertEquals(MeasuringBase.Heading(90.0), ruler.base, "It does not count from where that robot looks")
        assertNothingTouched()
    }

    @Test
    fun `the base of the protractor can be put onto a third point`() = onSheet {
        measure()
        sheet.performTouchInput { swipe(at(50.0, 40.0), at(30.0, 70.0), 200) }
        settle()
        assertEquals(-108.4, ruler.degrees, 2.0)
        assertNothingTouched()
    }

    @Test
    fun `a tap moves the end of the ruler, and two taps do not zoom`() = onSheet {
        measure()
        sheet.performTouchInput { click(at(50.0, 60.0)) }
        settle()
        sheet.performTouchInput { click(at(50.0, 60.0)) }
        settle()
        assertEquals(50.0, ruler.to.x, 0.3)
        assertEquals(1.0, camera.zoom)
    }

    @Test
    fun `a mouse drags an end`() = onSheet {
        measure()
        val from = at(90.0, 20.0)
        val to = at(90.0, 70.0)
        sheet.performMouseInput {
            moveTo(from)
            press()
            moveTo((from + to) / 2f)
            moveTo(to)
            release()
        }
        settle()
        assertEquals(70.0, ruler.to.y, 0.5)
    }

    @Test
    fun `keys move an end by a centimetre or a millimetre, put it onto things, and put all away`() = onSheet {
        measure()
        val end = onNodeWithTag(WorldTags.measure(MeasuringEnd.TO))
        end.requestFocus()
        end.performKeyInput {
            pressKey(Key.DirectionUp)
            withKeyDown(Key.ShiftLeft) { pressKey(Key.DirectionLeft) }
        }
        settle()
        assertEquals(89.9, ruler.to.x, 1e-9)
        assertEquals(21.0, ruler.to.y, 1e-9)
        end.performKeyInput { pressKey(Key.Enter) }
        settle()
        assertEquals(Point(30.0, 40.0), ruler.to)
        end.performKeyInput { pressKey(Key.Spacebar) }
        settle()
        assertEquals(Point(80.0, 60.0), ruler.to)
        end.assertContentDescriptionEquals("Measured to: a robot, 80.0 cm across and 60.0 cm up")
        assertNothingTouched()
        end.performKeyInput { pressKey(Key.Escape) }
        settle()
        assertNull(workshop.state.sheet.measuring)
    }

    @Test
    fun `a screen reader hears what is measured, and moves the ends`() = onSheet {
        measure()
        val described = onNodeWithTag(WorldTags.MEASURED).fetchSemanticsNode().config
        assertEquals(LiveRegionMode.Polite, described[SemanticsProperties.LiveRegion])
        onNodeWithTag(WorldTags.measure(MeasuringEnd.FROM))
            .assertContentDescriptionContains("Measured from: a robot", substring = true)
        onNodeWithTag(WorldTags.measure(MeasuringEnd.BASE))
            .assertContentDescriptionContains("50.0 cm across and 40.0 cm up", substring = true)
        onNodeWithTag(WorldTags.measure(MeasuringEnd.TO)).performSemanticsAction(SemanticsActions.OnClick)
        settle()
        onNodeWithTag(WorldTags.MEASURED).assertContentDescriptionEquals("31.6 cm, turn left 108.4 degrees")
        val moves = onNodeWithTag(WorldTags.measure(MeasuringEnd.TO))
            .fetchSemanticsNode().config[SemanticsActions.CustomActions]
        assertTrue(moves.first { it.label == "Move right" }.action())
        settle()
        assertEquals(21.0, ruler.to.x, 1e-9)
    }

    @Test
    fun `the robot is dragged again once all is put away`() = onSheet {
        measure()
        onNodeWithTag(WorldTags.SHEET_MEASURE).performClick()
        settle()
        sheet.performTouchInput { swipe(at(32.0, 40.0), at(52.0, 60.0), 160) }
        settle()
        assertEquals(50.0, workshop.state.session.robot.pose.x, 0.3)
    }

    private val SheetOnScreen.ruler: Measuring get() = assertNotNull(workshop.state.sheet.measuring)

    private fun SheetOnScreen.measure() {
        onNodeWithTag(WorldTags.SHEET_MEASURE).performClick()
        settle()
    }

    private fun SheetOnScreen.assertNothingTouched() = assertTrue(workshop.inputs.isEmpty(), "${workshop.inputs}")
}
