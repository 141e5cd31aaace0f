package robotran.ui.screen

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsSelected
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.performTouchInput
import robotran.brick.controls.BrickButton
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class PhoneTest {
    @Test
    fun `a program that ends while the robot drives is explained under the paper`() = onPhone { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited("start forward"))
        onNodeWithTag(RunTags.RUN).performClick()
        pass(1_000)
        onNodeWithTag(RunTags.BRICK_HINT).assertTextContains("has come to its end", substring = true)
    }

    @Test
    fun `three tabs show one pane each and the run bar is always there`() = onPhone {
        val panes = listOf(
            ScreenTags.tab(Pane.PROGRAM) to ProgramTags.PROGRAM,
            ScreenTags.tab(Pane.WORLD) to WorldTags.WORLD,
            ScreenTags.tab(Pane.BRICK) to RunTags.BRICK,
        )
        for ((tab, pane) in panes) {
            onNodeWithTag(tab).performClick()
            pass(300)
            onNodeWithTag(tab).assertIsSelected()
            onNodeWithTag(pane).assertIsDisplayed()
            onNodeWithTag(RunTags.RUN).assertIsDisplayed()
            onNodeWithTag(ScreenTags.MENU).assertIsDisplayed()
            for ((_, other) in panes.filter { it.second != pane }) {
                assertEquals(0, onAllNodesWithTag(other).fetchSemanticsNodes().size, "$other beside $pane")
            }
        }
    }

    @Test
    fun `beside the world the brick keeps its display and its Run`() = onPhone { workshop ->
        onNodeWithTag(RunTags.LCD).assertIsDisplayed()
        onNodeWithTag(RunTags.button(BrickButton.RUN)).performTouchInput { down(center) }
        pass(100)
        onNodeWithTag(RunTags.button(BrickButton.RUN)).performTouchInput { up() }
        pass(1500)
        assertTrue(workshop.state.session.ink.lengthCentimetres > 5)
    }

    @Test
    fun `a button that goes out of sight while it is held comes up`() = onPhone { workshop ->
        onNodeWithTag(RunTags.button(BrickButton.RUN)).performTouchInput { down(center) }
        pass(100)
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        pass(300)
        assertEquals(emptySet(), workshop.state.down)
    }

    @Test
    fun `held across, with text of twice the size, every button of the sheet is in sight`() =
        onScreen(891, 411) { workshop ->
            workshop.handle(SettingsEvent.SettingsChanged(Settings(textScale = 2f)))
            pass(300)
            val buttons =
                arrayOf(WorldTags.SHEET_WHOLE, WorldTags.SHEET_SHOW, WorldTags.SHEET_3D, WorldTags.SHEET_SURROUNDINGS)
            checkTargets(*buttons, RunTags.RUN, RunTags.STOP)
            val sheet = onNodeWithTag(WorldTags.WORLD).fetchSemanticsNode().boundsInRoot
            for (tag in buttons) {
                val button = onNodeWithTag(tag).fetchSemanticsNode().touchBoundsInRoot
                assertTrue(button.bottom <= sheet.bottom && button.top >= sheet.top, "$tag is at $button of $sheet")
            }
        }

    @Test
    fun `Run with a mistake shows the program and the mistake`() = onPhone {
        onNodeWithTag(ScreenTags.tab(Pane.PROGRAM)).performClick()
        pass(300)
        onNodeWithTag(ProgramTags.PROGRAM).performTextReplacement("beep\nbep")
        pass(100)
        onNodeWithTag(ScreenTags.tab(Pane.WORLD)).performClick()
        pass(300)
        onNodeWithTag(RunTags.RUN).performClick()
        pass(300)
        onNodeWithTag(ScreenTags.tab(Pane.PROGRAM)).assertIsSelected()
        onNodeWithText("Line 2:", substring = true).assertIsDisplayed()
    }
}
