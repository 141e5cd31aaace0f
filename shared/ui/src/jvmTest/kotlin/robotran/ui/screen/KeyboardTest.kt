package robotran.ui.screen

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.pressKey
import robotran.rom.BrickButton
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class KeyboardTest {
    @Test
    fun `the Tab key reaches Run, also out of the program, and space presses it`() = onTablet { workshop ->
        goTo("run")
        onRoot().performKeyInput { pressKey(Key.Spacebar) }
        pass(1500)
        assertTrue(workshop.state.session.ink.lengthCentimetres > 5)
    }

    @Test
    fun `the brick's Run goes down and up with the space key`() = onTablet { workshop ->
        goTo("brick-run")
        onRoot().performKeyInput { keyDown(Key.Spacebar) }
        pass(200)
        assertEquals(setOf(BrickButton.RUN), workshop.state.session.brick.pressed)
        assertFalse(workshop.state.running)
        onRoot().performKeyInput { keyUp(Key.Spacebar) }
        pass(100)
        assertTrue(workshop.state.running)
    }

    @Test
    fun `a button that loses the focus while its key is held comes up`() = onTablet { workshop ->
        goTo("brick-view")
        onRoot().performKeyInput { keyDown(Key.Enter) }
        pass(100)
        assertEquals(setOf(BrickButton.VIEW), workshop.state.down)
        onRoot().performKeyInput { pressKey(Key.Tab) }
        pass(100)
        assertEquals(emptySet(), workshop.state.down)
    }

    @Test
    fun `the arrow keys move the divider`() = onTablet {
        val before = onNodeWithTag("world").fetchSemanticsNode().size.width
        goTo("divider")
        onRoot().performKeyInput { pressKey(Key.DirectionRight) }
        pass(100)
        val after = onNodeWithTag("world").fetchSemanticsNode().size.width
        assertTrue(after < before, "the world was $before wide and is $after")
    }

    @Test
    fun `a screen reader's click presses and releases a button of the brick`() = onTablet { workshop ->
        onNodeWithTag("brick-run").performSemanticsAction(SemanticsActions.OnClick)
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
        /** More than there are things to focus. */
        const val STEPS = 60
    }
}
