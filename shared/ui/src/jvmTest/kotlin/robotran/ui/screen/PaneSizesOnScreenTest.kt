package robotran.ui.screen

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsOn
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.doubleClick
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.requestFocus
import androidx.compose.ui.test.swipe
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import robotran.workshop.state.WindowForm
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Tests the sizes that a pupil gives to panes and brick. */
@OptIn(ExperimentalTestApi::class)
class PaneSizesOnScreenTest {
    @Test
    fun `a finger gives the program more room, and a double tap takes it back`() {
        for ((width, height, isUpright) in WINDOWS) {
            onScreen(width, height) { workshop ->
                val described = "$width x $height"
                val before = bounds("program")
                onNodeWithTag("divider").performTouchInput {
                    swipe(center, center + if (isUpright) Offset(0f, -90f) else Offset(90f, 0f), 300)
                }
                pass(300)
                val after = bounds("program")
                val grown = if (isUpright) after.height - before.height else after.width - before.width
                assertEquals(90f, grown, 25f, described)
                val form = if (isUpright) WindowForm.UPRIGHT else WindowForm.ACROSS
                assertNotNull(workshop.state.settings.panes[form].programShare, "$described: it is not remembered")
                onNodeWithTag("divider").performTouchInput { doubleClick(center) }
                pass(600)
                assertEquals(before, bounds("program"), described)
                assertNull(workshop.state.settings.panes[form].programShare, described)
            }
        }
    }

    @Test
    fun `keys and screen readers move the divider, and Enter takes it back`() {
        for ((width, height, isUpright) in WINDOWS) {
            onScreen(width, height) {
                val described = "$width x $height"
                val before = bounds("program")
                val divider = onNodeWithTag("divider")
                divider.requestFocus()
                divider.performKeyInput {
                    repeat(3) { pressKey(if (isUpright) Key.DirectionUp else Key.DirectionRight) }
                }
                pass(300)
                val after = bounds("program")
                assertTrue(
                    after.height > before.height + 20 || after.width > before.width + 20,
                    "$described: $before, $after",
                )
                divider.performKeyInput { pressKey(Key.Enter) }
                pass(300)
                assertEquals(before, bounds("program"), described)
                val range = divider.fetchSemanticsNode().config[SemanticsProperties.ProgressBarRangeInfo]
                divider.performSemanticsAction(SemanticsActions.SetProgress) { it(range.range.endInclusive) }
                pass(300)
                val most = bounds("program")
                assertTrue(most.width > before.width || most.height > before.height, described)
                val reset = divider.fetchSemanticsNode().config[SemanticsActions.CustomActions].single()
                assertTrue(reset.action())
                pass(300)
                assertEquals(before, bounds("program"), described)
            }
        }
    }

    @Test
    fun `no pane can be made too small to be used`() {
        for ((width, height) in WINDOWS) {
            for (share in listOf(0.05f, 0.95f)) {
                onScreen(width, height) { workshop ->
                    val described = "$width x $height with $share"
                    for (form in WindowForm.entries) workshop.handle(SettingsEvent.ProgramShareChosen(form, share))
                    pass(300)
                    assertTrue(
                        bounds("program").run { this.width >= 300 && this.height >= 120 },
                        "$described: ${bounds("program")}",
                    )
                    assertTrue(
                        bounds("world").run { this.width >= 300 && this.height >= 150 },
                        "$described: ${bounds("world")}",
                    )
                    for (tag in listOf(
                        "undo",
                        "editor-more",
                        "sheet-measure",
                        "brick-size",
                        "run",
                        "stop",
                    )) {
                        assertWhole(tag, described)
                    }
                }
            }
        }
    }

    @Test
    fun `one touch shows the whole brick and one the small one, and nothing but the paper changes`() {
        for ((width, height) in WINDOWS.map { it.first to it.second } + listOf(1024 to 600, 1920 to 1080)) {
            onScreen(width, height) { workshop ->
                val described = "$width x $height"
                val form = WindowForm.entries.associateWith { workshop.state.settings.panes[it].isBrickWhole }
                val wasWhole = isThere("brick")
                val before = placesByTag()
                press("brick-size")
                assertTrue(isThere("brick") != wasWhole, described)
                val tags =
                    listOf("brick-size", "drawer-variables", "drawer-goals", "run", "timeline", "program", "divider")
                assertUnmoved(before, tags, described)
                if (!wasWhole) {
                    for (tag in listOf(
                        "brick-view",
                        "brick-on_off",
                        "brick-prgm",
                        "brick-run",
                    )) {
                        assertWhole(tag, described)
                    }
                }
                press("brick-size")
                assertEquals(wasWhole, isThere("brick"), described)
                assertUnmoved(before, before.keys - setOf("status"), described)
                assertTrue(
                    form != WindowForm.entries.associateWith {
                        workshop.state.settings.panes[it].isBrickWhole
                    },
                    described,
                )
            }
        }
    }

    @Test
    fun `why a program failed is one touch away from the button of the brick that it speaks of`() {
        for ((width, height) in listOf(1280 to 800, 820 to 1180, 411 to 891)) {
            onScreen(width, height) { workshop ->
                workshop.handle(ProgramEvent.ProgramEdited("var zero = 0\nshow 5 / zero\n"))
                workshop.handle(RunEvent.RunPressed)
                pass(2_000)
                press("brick-hint-whole")
                assertWhole("brick-on_off", "$width x $height")
                onNodeWithTag("brick-hint").assertTextContains("Press On-Off", substring = true)
                press("brick-on_off")
                assertTrue(!isThere("brick-hint"))
            }
        }
    }

    @Test
    fun `on a phone one touch shows the whole brick, and a tab the world again`() {
        for ((width, height) in listOf(411 to 891, 891 to 411)) {
            onScreen(width, height) { workshop ->
                press("brick-size")
                assertEquals(Pane.BRICK, workshop.state.pane)
                assertTrue(isThere("brick-on_off"))
                press("tab-world")
                assertTrue(isThere("world"))
            }
        }
    }

    @Test
    fun `program and world get all the room by one touch each, and neither Run nor the touched button moves`() {
        for ((width, height) in WINDOWS) {
            onScreen(width, height) { workshop ->
                val described = "$width x $height"
                val before = placesByTag()
                val still = listOf("menu", "full-program", "full-world", "run", "pause", "stop", "timeline", "run-more")
                press("full-world")
                onNodeWithTag("full-world").assertIsOn()
                assertTrue(!isThere("program") && !isThere("divider"), described)
                assertTrue(bounds("world").width > width * 0.9f && bounds("world").height > height * 0.6f, described)
                assertUnmoved(before, still, described)
                press("full-world")
                assertUnmoved(before, before.keys, described)
                press("full-program")
                assertTrue(!isThere("world") && bounds("program").height > height * 0.6f, described)
                assertUnmoved(before, still, described)
                press("run")
                assertTrue(isThere("world"), "$described: the robot that drives is not seen")
                assertUnmoved(before, still, described)
                workshop.handle(RunEvent.StopPressed)
                pass(300)
                assertEquals(before.getValue("program"), bounds("program"), described)
            }
        }
    }

    @Test
    fun `the drawer opens over its tabs, which stay where they are`() {
        for ((width, height) in WINDOWS) {
            onScreen(width, height) { workshop ->
                val before = placesByTag()
                assertEquals(0f, bounds("drawer").height, "the closed drawer takes room")
                press("drawer-log")
                assertEquals(DrawerTab.LOG, workshop.state.run.drawer.tab)
                assertTrue(
                    bounds("drawer").height > 150 && bounds("world").height > 100,
                    "${bounds("drawer")} ${bounds("world")}",
                )
                val tags =
                    DrawerTab.entries.map { "drawer-${it.name.lowercase()}" } +
                        listOf("run", "timeline", "brick-size", "program")
                assertUnmoved(before, tags, "$width x $height")
                press("drawer-log")
                assertUnmoved(before, before.keys, "$width x $height")
            }
        }
    }

    @Test
    fun `Back gives both panes their room again`() = onScreen(1280, 800) { workshop ->
        workshop.handle(ScreenEvent.PaneFilled(Pane.PROGRAM))
        assertEquals(listOf(ScreenEvent.PaneFilled(null)), paneBackEvents(workshop.state, isWide = true))
        assertEquals(
            emptyList(),
            paneBackEvents(workshop.state, isWide = false).filterIsInstance<ScreenEvent.PaneFilled>(),
        )
    }

    private fun ComposeUiTest.press(tag: String) {
        onNodeWithTag(tag).performClick()
        pass(500)
    }

    private fun ComposeUiTest.bounds(tag: String): Rect = onNodeWithTag(tag).fetchSemanticsNode().boundsInRoot

    private companion object {
        val WINDOWS = listOf(Triple(1280, 800, false), Triple(820, 1180, true), Triple(1440, 900, false))
    }
}
