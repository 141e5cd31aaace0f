package robotran.uikit

import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsNode
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.assertIsOff
import androidx.compose.ui.test.assertIsOn
import androidx.compose.ui.test.hasClickAction
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.runDesktopComposeUiTest
import robotran.uikit.preview.Controls
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** What screen readers, fingers and large text need of every control, so that screens need not test it. */
@OptIn(ExperimentalTestApi::class)
class ControlsTest {
    @Test
    fun `every control is large enough for a finger, with text of every size`() {
        for (scale in listOf(1f, 2f)) {
            controls(scale) {
                for (node in clickable()) {
                    val size = node.touchBoundsInRoot.size
                    val least = 48f - ROUNDING
                    assertTrue(size.width >= least && size.height >= least, "${nameOf(node)} at $scale is $size")
                }
            }
        }
    }

    @Test
    fun `every control has a name and a role`() = controls {
        for (node in clickable()) {
            assertTrue(nameOf(node).isNotBlank(), "${tagOf(node)} has no name")
            // A field says by itself that it is one.
            val hasRole = node.config.getOrNull(SemanticsProperties.Role) != null || isField(node)
            assertTrue(hasRole, "${tagOf(node)} has no role")
        }
    }

    @Test
    fun `every control can be reached by keys`() = controls {
        for (node in clickable().filter { SemanticsProperties.Disabled !in it.config }) {
            assertTrue(SemanticsProperties.Focused in node.config, "${tagOf(node)} cannot have the focus")
        }
    }

    @Test
    fun `every control has its tag, and does what it is for`() {
        val pressed = mutableListOf<String>()
        runDesktopComposeUiTest(WIDTH, HEIGHT) {
            setContent { KitTheme(RobotranColours.LIGHT) { Controls { pressed += it } } }
            val tags = clickable().filter { SemanticsProperties.Disabled !in it.config && !isField(it) }.map(::tagOf)
            assertEquals(tags, tags.distinct())
            for (tag in tags) onNodeWithTag(tag).performClick()
            assertEquals(tags, pressed)
        }
    }

    @Test
    fun `a disabled button says so`() = controls {
        onNodeWithTag("disabled").assertIsNotEnabled()
        onNodeWithTag("disabled-icon").assertIsNotEnabled()
    }

    @Test
    fun `switches say whether they are on`() = controls {
        onNodeWithTag("switch-row").assertIsOn()
        onNodeWithTag("icon-switch").assertIsOff()
        assertEquals(Role.Switch, onNodeWithTag("icon-switch").fetchSemanticsNode().config[SemanticsProperties.Role])
    }

    @Test
    fun `a slider says its name and its value in words`() = controls {
        val slider = onNodeWithTag("slider").fetchSemanticsNode().config
        assertEquals(listOf("Speed"), slider[SemanticsProperties.ContentDescription])
        assertEquals("half", slider[SemanticsProperties.StateDescription])
        assertTrue(SemanticsActions.SetProgress in slider)
    }

    private fun controls(scale: Float = 1f, check: ComposeUiTest.() -> Unit) = runDesktopComposeUiTest(WIDTH, HEIGHT) {
        setContent { KitTheme(RobotranColours.LIGHT, scale) { Controls { } } }
        check()
    }

    private fun ComposeUiTest.clickable(): List<SemanticsNode> {
        val nodes = onAllNodes(hasClickAction() and SemanticsMatcher.keyIsDefined(SemanticsProperties.TestTag))
            .fetchSemanticsNodes()
        assertTrue(nodes.size > 20, "only ${nodes.size}")
        return nodes
    }

    private fun isField(node: SemanticsNode) = SemanticsActions.SetText in node.config

    private fun tagOf(node: SemanticsNode) = node.config[SemanticsProperties.TestTag]

    private fun nameOf(node: SemanticsNode): String = (
        node.config.getOrNull(SemanticsProperties.ContentDescription).orEmpty() +
            node.config.getOrNull(SemanticsProperties.Text).orEmpty().map { it.text }
    ).joinToString(" ")

    private companion object {
        /** All controls are in sight, also with large text. */
        const val WIDTH = 800
        const val HEIGHT = 4_000

        /** Of pixels. */
        const val ROUNDING = 0.5f
    }
}
