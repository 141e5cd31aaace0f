package robotran.uikit

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
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
import androidx.compose.ui.test.runComposeUiTest
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
            assertTrue(node.config.getOrNull(SemanticsProperties.Role) != null, "${tagOf(node)} has no role")
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
        runComposeUiTest {
            setContent { KitTheme(RobotranColours.LIGHT) { Controls { pressed += it } } }
            val tags = clickable().filter { SemanticsProperties.Disabled !in it.config }.map(::tagOf)
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

    private fun controls(scale: Float = 1f, check: ComposeUiTest.() -> Unit) = runComposeUiTest {
        setContent { KitTheme(RobotranColours.LIGHT, scale) { Controls { } } }
        check()
    }

    private fun ComposeUiTest.clickable(): List<SemanticsNode> {
        val nodes = onAllNodes(hasClickAction() and SemanticsMatcher.keyIsDefined(SemanticsProperties.TestTag))
            .fetchSemanticsNodes()
        assertTrue(nodes.size > 20, "only ${nodes.size}")
        return nodes
    }

    private fun tagOf(node: SemanticsNode) = node.config[SemanticsProperties.TestTag]

    private fun nameOf(node: SemanticsNode): String = (
        node.config.getOrNull(SemanticsProperties.ContentDescription).orEmpty() +
            node.config.getOrNull(SemanticsProperties.Text).orEmpty().map { it.text }
    ).joinToString(" ")

    private companion object {
        /** Of pixels. */
        const val ROUNDING = 0.5f
    }
}

/** One of each control, which passes its tag to [onPress]. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Controls(onPress: (String) -> Unit) = Column(Modifier.verticalScroll(rememberScrollState())) {
    FlowRow {
        for (kind in ButtonKind.entries) {
            val tag = "button-${kind.name.lowercase()}"
            Button("Go", tag, kind) { onPress(tag) }
        }
        Button("Go", "disabled", enabled = false) { onPress("disabled") }
        BarButton(RunIcons.PLAY, BarWords("Run", "Runs it"), "bar", room = false) { onPress("bar") }
    }
    FlowRow {
        for (kind in IconButtonKind.entries) {
            val tag = "icon-${kind.name.lowercase()}"
            IconButton(Icon.MENU, "Menu", tag, kind) { onPress(tag) }
        }
        IconButton(ThinIcons.UNDO, "Undo", "disabled-icon", IconButtonKind.TOOL, enabled = false) { onPress("no") }
        IconSwitch(Icon.BOOK, "Book", "icon-switch", on = false) { onPress("icon-switch") }
        IconWord(EditIcons.COPY, "Copy", "icon-word", { onPress("icon-word") })
    }
    FlowRow {
        Chip("All", true, "chip") { onPress("chip") }
        SmallChip("Aa", false, "small-chip", Color.Unspecified) { onPress("small-chip") }
        WordButton("Open", "word", { onPress("word") })
        DialogButton("7", "key") { onPress("key") }
    }
    ChipRow("Side", listOf(1 to "left", 2 to "right"), 1, "side") { onPress("side-${it - 1}") }
    ChoiceOfOne("Theme", listOf(1 to "light", 2 to "dark"), 1, "theme") { onPress("theme-${it - 1}") }
    SwitchRow("Sound", true, "switch-row") { onPress("switch-row") }
    Tabs(listOf(Tab("Program", "tab-0"), Tab("World", "tab-1")), 0) { onPress("tab-$it") }
    Slider(0.5f, SliderWords("Speed", "half", "slider")) { }
}
