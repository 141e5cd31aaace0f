package robotran.ui.screen

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher

/** The places of all elements that can be pressed, by tag. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.pressablePlaces(): Map<String, Rect> = onAllNodes(TAGGED).fetchSemanticsNodes()
    .groupBy { it.config[SemanticsProperties.TestTag] }
    .filter { (tag, nodes) -> tag in PRESSABLE && nodes.size == 1 }
    .mapValues { (_, nodes) -> nodes.single().boundsInRoot }

private val TAGGED = SemanticsMatcher.keyIsDefined(SemanticsProperties.TestTag)
private val PRESSABLE = setOf(
    "menu",
    "learn",
    "worlds",
    "edit-world",
    "tab-program",
    "tab-world",
    "tab-brick",
    "run",
    "pause",
    "step",
    "steps",
    "stop",
    "speed",
    "run-more",
    "sound",
    "timeline",
    "mark-previous",
    "mark-next",
    "world",
    "sheet-nearer",
    "sheet-whole",
    "sheet-show",
    "sheet-3d",
    "sheet-surroundings",
    "drawer-variables",
    "drawer-goals",
    "goal-chip",
    "brick",
    "brick-run",
    "brick-view",
    "brick-prgm",
    "brick-on_off",
    "program",
    "undo",
    "editor-more",
    "program-0",
    "add-program",
    "divider",
)
