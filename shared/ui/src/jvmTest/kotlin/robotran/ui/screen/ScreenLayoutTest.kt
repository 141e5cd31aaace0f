package robotran.ui.screen

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.semantics.SemanticsNode
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.brick.controls.BrickButton
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests the positions of elements on screens of all sizes, and that they do not move. */
@OptIn(ExperimentalTestApi::class)
class ScreenLayoutTest {
    @Test
    fun `why a program failed is told beside the sheet, to its end by scrolling, and covers nothing`() {
        for ((width, height) in listOf(
            1366 to 768,
            1280 to 720,
            1180 to 820,
            1024 to 768,
            1440 to 900,
            820 to 1180,
            412 to 915,
        )) {
            onScreen(width, height) { workshop ->
                workshop.handle(LearningEvent.WorldChosen("maze"))
                workshop.write("var zero = 0\nshow 5 / zero\n")
                workshop.handle(RunEvent.RunPressed)
                pass(2_000)
                val hint = node(RunTags.BRICK_HINT)
                val isWhole = hint.size.height - hint.boundsInRoot.height < 1f
                assertTrue(isWhole || saysThereIsMore(ScreenTags.NEWS), "$width x $height: the text is cut")
                val others =
                    listOf(
                        RunTags.BRICK,
                        RunTags.LCD,
                        RunTags.button(BrickButton.RUN),
                        RunTags.button(BrickButton.ON_OFF),
                        RunTags.GOAL_CHIP,
                        RunTags.RUN,
                        RunTags.STOP,
                        RunTags.TIMELINE,
                        WorldTags.SHEET_SHOW,
                    )
                for (tag in others.filter { onAllNodesWithTag(it).fetchSemanticsNodes().isNotEmpty() }) {
                    val other = node(tag)
                    assertEquals(
                        other.size.height.toFloat(),
                        other.boundsInRoot.height,
                        1f,
                        "$width x $height: $tag is cut",
                    )
                    assertEquals(
                        other.size.width.toFloat(),
                        other.boundsInRoot.width,
                        1f,
                        "$width x $height: $tag is cut",
                    )
                    assertTrue(
                        !other.boundsInRoot.overlaps(hint.boundsInRoot),
                        "$width x $height: $tag and the hint lie over each other",
                    )
                }
            }
        }
    }

    @Test
    fun `a tutorial leaves the paper most of the room beside the program`() = onScreen(1180, 820) { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(500)
        assertTrue(bounds(WorldTags.WORLD).width > 500f, "${bounds("world")}")
        val pane = bounds(ProgramTags.program(0)).left..bounds(WorldTags.WORLD).left
        for (tag in listOf(ProgramTags.UNDO, ProgramTags.FIND_OPEN, ProgramTags.VIEW_SWITCH, ProgramTags.EDITOR_MORE)) {
            val tool = node(tag)
            assertEquals(tool.size.width.toFloat(), tool.boundsInRoot.width, 0.5f, "$tag is cut")
            val place = tool.boundsInRoot
            assertTrue(place.right <= pane.endInclusive && place.left >= pane.start, "$tag is at $place")
        }
    }

    @Test
    fun `a tablet held upright shows tutorial, paper, brick and program over each other`() =
        onScreen(820, 1180) { workshop ->
            for (tag in listOf(
                WorldTags.WORLD,
                RunTags.button(BrickButton.RUN),
                RunTags.RUN,
                ProgramTags.PROGRAM,
                RunTags.tab(RunTags.DRAWER, DrawerTab.VARIABLES),
                ScreenTags.LEARN,
            )) {
                onNodeWithTag(tag).assertIsDisplayed()
            }
            assertEquals(0, onAllNodesWithTag(ScreenTags.tab(Pane.PROGRAM)).fetchSemanticsNodes().size)
            workshop.handle(LearningEvent.TutorialStarted)
            pass(500)
            for (tag in listOf(
                LearningTags.TUTORIAL,
                LearningTags.TASK,
                LearningTags.NEXT_STEP,
                WorldTags.WORLD,
                RunTags.LCD,
                RunTags.RUN,
                ProgramTags.PROGRAM,
            )) {
                onNodeWithTag(tag).assertIsDisplayed()
            }
            assertTrue(
                bounds(LearningTags.TUTORIAL).bottom <= bounds(WorldTags.WORLD).top &&
                    bounds(WorldTags.WORLD).bottom <= bounds(ProgramTags.PROGRAM).top,
            )
            assertTrue(
                bounds(WorldTags.WORLD).height > 240f && bounds(ProgramTags.PROGRAM).height > 200f,
                "${bounds("world")} ${bounds("program")}",
            )
            workshop.handle(RunEvent.RunPressed)
            pass(500)
            for (tag in listOf("tutorial", "world", "program")) onNodeWithTag(tag).assertIsDisplayed()
            workshop.handle(RunEvent.DrawerChosen(DrawerTab.LOG))
            pass(500)
            assertTrue(bounds(WorldTags.WORLD).height > 120f, "${bounds("world")}")
            workshop.handle(LearningEvent.WordChosen(null))
            pass(500)
            assertTrue(
                bounds(ProgramTags.HELP).bottom <= bounds(RunTags.RUN).top,
                "${bounds("help")} over ${bounds("run")}",
            )
            assertTrue(
                bounds(ProgramTags.HELP).top >= bounds(WorldTags.WORLD).bottom,
                "${bounds("help")} over ${bounds("world")}",
            )
        }

    @Test
    fun `help on words leaves Run free`() {
        for ((width, height) in listOf(1366 to 768, 1180 to 820, 1024 to 768, 1440 to 900)) {
            onScreen(width, height) { workshop ->
                workshop.handle(LearningEvent.WordChosen(null))
                pass(500)
                assertTrue(
                    bounds(ProgramTags.HELP).bottom <= bounds(RunTags.RUN).top,
                    "$width x $height: ${bounds("help")} over ${bounds("run")}",
                )
            }
        }
    }

    @Test
    fun `a menu that fits on the screen does not scroll`() {
        for ((width, height) in listOf(1366 to 768, 820 to 1180, 412 to 915)) {
            for (menu in listOf(
                ScreenTags.MENU,
                ProgramTags.EDITOR_MORE,
                ProgramTags.ADD_PROGRAM,
                WorldTags.SHEET_SHOW,
                RunTags.SPEED,
                RunTags.STEPS,
            )) {
                onScreen(width, height) { workshop ->
                    if (menu in
                        listOf(ProgramTags.EDITOR_MORE, ProgramTags.ADD_PROGRAM)
                    ) {
                        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                    }
                    pass(300)
                    if (onAllNodesWithTag(menu).fetchSemanticsNodes().isEmpty()) return@onScreen
                    onNodeWithTag(menu).performClick()
                    pass(600)
                    val list = onAllNodes(SCROLLS_DOWN).fetchSemanticsNodes().single { it.isInMenu() }
                    val hidden = list.config[SemanticsProperties.VerticalScrollAxisRange].maxValue()
                    val whole = list.boundsInRoot.height + hidden
                    if (whole <= height - 2 * SPARE) assertEquals(0f, hidden, "$menu on $width x $height: $whole")
                }
            }
        }
    }

    @Test
    fun `large text leaves the goals uncovered`() {
        for ((width, height) in listOf(1366 to 768, 1180 to 820, 820 to 1180, 412 to 915, 891 to 411)) {
            onScreen(width, height) { workshop ->
                workshop.handle(SettingsEvent.SettingsChanged(Settings(textScale = 2f)))
                workshop.handle(LearningEvent.WorldChosen("maze"))
                workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
                pass(500)
                val chip = node(RunTags.GOAL_CHIP)
                assertEquals(chip.size.height.toFloat(), chip.boundsInRoot.height, 0.5f, "$width x $height")
                assertEquals(chip.size.width.toFloat(), chip.boundsInRoot.width, 0.5f, "$width x $height")
                for (tag in listOf(
                    RunTags.BRICK,
                    RunTags.LCD,
                    RunTags.button(BrickButton.RUN),
                    RunTags.tab(RunTags.DRAWER, DrawerTab.GOALS),
                    RunTags.RUN,
                )) {
                    if (onAllNodesWithTag(tag).fetchSemanticsNodes().isEmpty()) continue
                    assertTrue(!bounds(tag).overlaps(chip.boundsInRoot), "$width x $height: $tag lies over the goals")
                }
            }
        }
    }

    @Test
    fun `a program that ends without its goal says so, and not that all is done`() = onScreen(1366, 768) { workshop ->
        workshop.handle(LearningEvent.WorldChosen("maze"))
        workshop.write("forward 2\n")
        workshop.handle(RunEvent.RunPressed)
        pass(5_000)
        onNodeWithTag(RunTags.STATUS).assertTextEquals("Program ended. Goal not met.")
        onNodeWithTag(RunTags.GOAL_CHIP).performClick()
        pass(500)
        val described = onAllNodesWithTag(RunTags.GOAL).fetchSemanticsNodes().map { goal ->
            val words = goal.config.getOrElse(SemanticsProperties.Text) { emptyList() }.joinToString { it.text }
            goal.config[SemanticsProperties.StateDescription] to words
        }
        assertTrue(described.any { it.first == "not met" }, described.toString())
        assertTrue(described.none { "not met" in it.second }, "Screen readers hear it twice: $described")
    }

    private fun Workshop.write(program: String) = handle(ProgramEvent.ProgramEdited(program))

    private fun ComposeUiTest.node(tag: String): SemanticsNode = onNodeWithTag(tag).fetchSemanticsNode()

    private fun ComposeUiTest.bounds(tag: String): Rect = node(tag).boundsInRoot

    private fun SemanticsNode.isInMenu() = generateSequence(this) {
        it.parent
    }.any { it.config.contains(SemanticsProperties.IsPopup) }

    private companion object {
        val SCROLLS_DOWN = SemanticsMatcher.keyIsDefined(SemanticsProperties.VerticalScrollAxisRange)

        /** The free space above and below a menu. */
        const val SPARE = 64
    }
}
