package robotran.ui.screen

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.hasAnyAncestor
import androidx.compose.ui.test.hasTestTag
import androidx.compose.ui.test.isFocused
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.withKeyDown
import androidx.compose.ui.test.withKeysDown
import robotran.brick.controls.BrickButton
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.LearningPage
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class KeyboardTest {
    @Test
    fun `the Tab key reaches Run, also out of the program, and space presses it`() = onTablet { workshop ->
        goTo(RunTags.RUN)
        onRoot().performKeyInput { pressKey(Key.Spacebar) }
        pass(1500)
        assertTrue(workshop.state.session.ink.lengthCentimetres > 5)
    }

    @Test
    fun `keys run, pause, step and stop from inside the program`() = onTablet { workshop ->
        onNodeWithTag(ProgramTags.PROGRAM).performClick()
        onRoot().performKeyInput { withKeyDown(Key.CtrlLeft) { pressKey(Key.Enter) } }
        pass(300)
        assertTrue(workshop.state.running)
        onRoot().performKeyInput { pressKey(Key.F6) }
        pass(100)
        assertTrue(workshop.state.run.isPaused)
        val before = workshop.state.run.time
        onRoot().performKeyInput { pressKey(Key.F7) }
        pass(6_000)
        assertTrue(workshop.state.run.isPaused)
        assertTrue(workshop.state.run.time > before)
        onRoot().performKeyInput { withKeysDown(listOf(Key.CtrlLeft, Key.ShiftLeft)) { pressKey(Key.Enter) } }
        pass(300)
        assertFalse(workshop.state.running)
    }

    @Test
    fun `the brick's Run goes down and up with the space key`() = onTablet { workshop ->
        goTo(RunTags.button(BrickButton.RUN))
        onRoot().performKeyInput { keyDown(Key.Spacebar) }
        pass(200)
        assertEquals(setOf(BrickButton.RUN), workshop.state.session.brick.pressed)
        assertFalse(workshop.state.running)
        onRoot().performKeyInput { keyUp(Key.Spacebar) }
        pass(100)
        assertTrue(workshop.state.running)
    }

    @Test
    fun `a button that loses the focus while its key is held comes up`() = onTabletWithBrick { workshop ->
        goTo(RunTags.button(BrickButton.VIEW))
        onRoot().performKeyInput { keyDown(Key.Enter) }
        pass(100)
        assertEquals(setOf(BrickButton.VIEW), workshop.state.down)
        onRoot().performKeyInput { pressKey(Key.Tab) }
        pass(100)
        assertEquals(emptySet(), workshop.state.down)
    }

    @Test
    fun `the arrow keys move the divider`() = onTablet {
        val before = onNodeWithTag(WorldTags.WORLD).fetchSemanticsNode().size.width
        goTo(ScreenTags.DIVIDER)
        onRoot().performKeyInput { pressKey(Key.DirectionRight) }
        pass(100)
        val after = onNodeWithTag(WorldTags.WORLD).fetchSemanticsNode().size.width
        assertTrue(after < before, "the world was $before wide and is $after")
    }

    @Test
    fun `what lies under a page is neither reached by the Tab key nor told`() = onTablet { workshop ->
        for (page in listOf(LearningEvent.PageRequested(LearningPage.FIRST_RUN), SettingsEvent.SettingsShown(true))) {
            workshop.handle(page)
            pass(300)
            onNodeWithTag(RunTags.RUN).assertDoesNotExist()
            val onPage =
                hasAnyAncestor(hasTestTag(LearningTags.FIRST_RUN)) or hasAnyAncestor(hasTestTag(ScreenTags.SETTINGS))
            repeat(STEPS_ON_PAGE) {
                onRoot().performKeyInput { pressKey(Key.Tab) }
                pass(50)
                onNode(isFocused() and onPage).assertExists()
            }
            onRoot().performKeyInput { pressKey(Key.Escape) }
            pass(300)
            goTo(RunTags.RUN)
        }
    }

    @Test
    fun `a screen reader's click presses and releases a button of the brick`() = onTablet { workshop ->
        onNodeWithTag(RunTags.button(BrickButton.RUN)).performSemanticsAction(SemanticsActions.OnClick)
        pass(100)
        assertTrue(workshop.state.running)
        assertEquals(emptySet(), workshop.state.down)
    }

    /** Presses Tab until the node with [tag] has the focus. */
    private fun ComposeUiTest.goTo(tag: String) {
        repeat(STEPS) {
            if (onNodeWithTag(tag).fetchSemanticsNode().config.getOrNull(SemanticsProperties.Focused) == true) return
            onRoot().performKeyInput { pressKey(Key.Tab) }
            pass(50)
        }
        error("The Tab key does not reach $tag")
    }

    private companion object {
        /** More than the number of focusable elements. */
        const val STEPS = 60

        /** More than the number of focusable elements on one page. */
        const val STEPS_ON_PAGE = 30
    }
}
