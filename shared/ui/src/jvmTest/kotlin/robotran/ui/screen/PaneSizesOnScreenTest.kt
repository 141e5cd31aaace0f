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
import robotran.brick.controls.BrickButton
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
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
                val before = bounds(ProgramTags.PROGRAM)
                onNodeWithTag(ScreenTags.DIVIDER).performTouchInput {
                    swipe(center, center + if (isUpright) Offset(0f, -90f) else Offset(90f, 0f), 300)
                }
                pass(300)
                val after = bounds(ProgramTags.PROGRAM)
                val grown = if (isUpright) after.height - before.height else after.width - before.width
                assertEquals(90f, grown, 25f, described)
                val form = if (isUpright) WindowForm.UPRIGHT else WindowForm.ACROSS
                assertNotNull(workshop.state.settings.panes[form].programShare, "$described: it is not remembered")
                onNodeWithTag(ScreenTags.DIVIDER).performTouchInput { doubleClick(center) }
                pass(600)
                assertEquals(before, bounds(ProgramTags.PROGRAM), described)
                assertNull(workshop.state.settings.panes[form].programShare, described)
            }
        }
    }

    @Test
    fun `keys and screen readers move the divider, and Enter takes it back`() {
        for ((width, height, isUpright) in WINDOWS) {
            onScreen(width, height) {
                val described = "$width x $height"
                val before = bounds(ProgramTags.PROGRAM)
                val divider = onNodeWithTag(ScreenTags.DIVIDER)
                divider.requestFocus()
                divider.performKeyInput {
                    repeat(3) { pressKey(if (isUpright) Key.DirectionUp else Key.DirectionRight) }
                }
                pass(300)
                val after = bounds(ProgramTags.PROGRAM)
                assertTrue(
                    after.height > before.height + 20 || after.width > before.width + 20,
                    "$described: $before, $after",
                )
                divider.performKeyInput { pressKey(Key.Enter) }
                pass(300)
                assertEquals(before, bounds(ProgramTags.PROGRAM), described)
                val range = divider.fetchSemanticsNode().config[SemanticsProperties.ProgressBarRangeInfo]
                divider.performSemanticsAction(SemanticsActions.SetProgress) { it(range.range.endInclusive) }
                pass(300)
                val most = bounds(ProgramTags.PROGRAM)
                assertTrue(most.width > before.width || most.height > before.height, described)
                val reset = divider.fetchSemanticsNode().config[SemanticsActions.CustomActions].single()
                assertTrue(reset.action())
                pass(300)
                assertEquals(before, bounds(ProgramTags.PROGRAM), described)
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
                        bounds(ProgramTags.PROGRAM).run { this.width >= 300 && this.height >= 120 },
                        "$described: ${bounds("program")}",
                    )
                    assertTrue(
                        bounds(WorldTags.WORLD).run { this.width >= 300 && this.height >= 150 },
                        "$described: ${bounds("world")}",
                    )
                    for (tag in listOf(
                        ProgramTags.UNDO,
                        ProgramTags.EDITOR_MORE,
                        WorldTags.SHEET_MEASURE,
                        ScreenTags.BRICK_SIZE,
                        RunTags.RUN,
                        RunTags.STOP,
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
                val wasWhole = isThere(RunTags.BRICK)
                val before = placesByTag()
                press(ScreenTags.BRICK_SIZE)
                assertTrue(isThere(RunTags.BRICK) != wasWhole, described)
                val tags =
                    listOf(
                        ScreenTags.BRICK_SIZE,
                        RunTags.tab(RunTags.DRAWER, DrawerTab.VARIABLES),
                        RunTags.tab(RunTags.DRAWER, DrawerTab.GOALS),
                        RunTags.RUN,
                        RunTags.TIMELINE,
                        ProgramTags.PROGRAM,
                        ScreenTags.DIVIDER,
                    )
                assertUnmoved(before, tags, described)
                if (!wasWhole) {
                    for (tag in listOf(
                        RunTags.button(BrickButton.VIEW),
                        RunTags.button(BrickButton.ON_OFF),
                        RunTags.button(BrickButton.PRGM),
                        RunTags.button(BrickButton.RUN),
                    )) {
                        assertWhole(tag, described)
                    }
                }
                press(ScreenTags.BRICK_SIZE)
                assertEquals(wasWhole, isThere(RunTags.BRICK), described)
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
                press(ScreenTags.BRICK_HINT_WHOLE)
                assertWhole(RunTags.button(BrickButton.ON_OFF), "$width x $height")
                onNodeWithTag(RunTags.BRICK_HINT).assertTextContains("Press On-Off", substring = true)
                press(RunTags.button(BrickButton.ON_OFF))
                assertTrue(!isThere(RunTags.BRICK_HINT))
            }
        }
    }

    @Test
    fun `on a phone one touch shows the whole brick, and a tab the world again`() {
        for ((width, height) in listOf(411 to 891, 891 to 411)) {
            onScreen(width, height) { workshop ->
                press(ScreenTags.BRICK_SIZE)
                assertEquals(Pane.BRICK, workshop.state.pane)
                assertTrue(isThere(RunTags.button(BrickButton.ON_OFF)))
                press(ScreenTags.tab(Pane.WORLD))
                assertTrue(isThere(WorldTags.WORLD))
            }
        }
    }

    @Test
    fun `program and world get all the room by one touch each, and neither Run nor the touched button moves`() {
        for ((width, height) in WINDOWS) {
            onScreen(width, height) { workshop ->
                val described = "$width x $height"
                val before = placesByTag()
                val still =
                    listOf(
                        ScreenTags.MENU,
                        ScreenTags.FULL_PROGRAM,
                        ScreenTags.FULL_WORLD,
                        RunTags.RUN,
                        RunTags.PAUSE,
                        RunTags.STOP,
                        RunTags.TIMELINE,
                        RunTags.RUN_MORE,
                    )
                press(ScreenTags.FULL_WORLD)
                onNodeWithTag(ScreenTags.FULL_WORLD).assertIsOn()
                assertTrue(!isThere(ProgramTags.PROGRAM) && !isThere(ScreenTags.DIVIDER), described)
                assertTrue(
                    bounds(WorldTags.WORLD).run { this.width * this.height } > width * height * 0.5f,
                    described,
                )
                assertUnmoved(before, still, described)
                press(ScreenTags.FULL_WORLD)
                assertUnmoved(before, before.keys, described)
                press(ScreenTags.FULL_PROGRAM)
                assertTrue(!isThere(WorldTags.WORLD) && bounds(ProgramTags.PROGRAM).height > height * 0.6f, described)
                assertUnmoved(before, still, described)
                press(RunTags.RUN)
                assertTrue(isThere(WorldTags.WORLD), "$described: the robot that drives is not seen")
                assertUnmoved(before, still, described)
                workshop.handle(RunEvent.StopPressed)
                pass(300)
                assertEquals(before.getValue("program"), bounds(ProgramTags.PROGRAM), described)
            }
        }
    }

    @Test
    fun `the drawer opens over its tabs, which stay where they are`() {
        for ((width, height) in WINDOWS) {
            onScreen(width, height) { workshop ->
                val before = placesByTag()
                assertEquals(0f, bounds(RunTags.DRAWER).height, "the closed drawer takes room")
                press(RunTags.tab(RunTags.DRAWER, DrawerTab.LOG))
                assertEquals(DrawerTab.LOG, workshop.state.run.drawer.tab)
                assertTrue(
                    bounds(RunTags.DRAWER).height > 150 && bounds(WorldTags.WORLD).height > 100,
                    "${bounds("drawer")} ${bounds("world")}",
                )
                val tags =
                    DrawerTab.entries.map { "drawer-${it.name.lowercase()}" } +
                        listOf(RunTags.RUN, RunTags.TIMELINE, ScreenTags.BRICK_SIZE, ProgramTags.PROGRAM)
                assertUnmoved(before, tags, "$width x $height")
                press(RunTags.tab(RunTags.DRAWER, DrawerTab.LOG))
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
