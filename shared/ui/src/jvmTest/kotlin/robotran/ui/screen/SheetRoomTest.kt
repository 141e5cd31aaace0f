package robotran.ui.screen

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.math.roundToInt
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests how much of the window the sheet has, and that all that belongs beside it fits. */
@OptIn(ExperimentalTestApi::class)
class SheetRoomTest {
    @Test
    fun `the sheet has this part of each window`() {
        val measured = SHARES.map { (size, _) ->
            size to SCALES.map { scale ->
                var share = 0
                onWindow(size, Settings(textScale = scale, lessMotion = true)) {
                    share = shareOf(WorldTags.WORLD, size)
                }
                share
            }
        }
        assertEquals(SHARES, measured)
    }

    @Test
    fun `the sheet has at least half of the area beside the program`() {
        for (size in SHARES.map { it.first }) {
            for (world in listOf("plain", "maze", "block-push")) {
                onWindow(size, Settings(lessMotion = true)) {
                    it.handle(LearningEvent.WorldChosen(world))
                    pass(300)
                    val others = listOf(ScreenTags.MESSAGES, RunTags.BRICK).filter { tag -> isThere(tag) }
                    val rest = others.sumOf { tag -> shareOf(tag, size) }
                    assertTrue(shareOf(WorldTags.WORLD, size) >= rest, "$world at $size: $rest % for $others")
                }
            }
        }
    }

    @Test
    fun `upright, the pane of the program has 45 percent of the height`() = onWindow(820 to 1180, Settings()) {
        val pane = bounds(RunTags.RUN).top - bounds(ScreenTags.DIVIDER).center.y
        assertTrue(pane / 1180 >= 0.45f, "$pane")
    }

    private fun onWindow(size: Pair<Int, Int>, settings: Settings, check: ComposeUiTest.(Workshop) -> Unit) =
        onScreen(size.first, size.second) { workshop ->
            workshop.handle(SettingsEvent.SettingsChanged(settings))
            workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
            pass(500)
            check(workshop)
        }

    private fun ComposeUiTest.shareOf(tag: String, size: Pair<Int, Int>): Int =
        bounds(tag).run { (width * height * 100 / (size.first * size.second)).roundToInt() }

    private fun ComposeUiTest.bounds(tag: String): Rect = onNodeWithTag(tag).fetchSemanticsNode().boundsInRoot

    private companion object {
        val SCALES = listOf(1f, 2f)

        /** For each window the part of the sheet's pane, in percent of its area at text of 100 and 200 %. */
        val SHARES = listOf(
            Pair(360 to 640, listOf(42, 30)),
            Pair(411 to 891, listOf(45, 45)),
            Pair(640 to 360, listOf(26, 20)),
            Pair(891 to 411, listOf(34, 26)),
            Pair(820 to 1180, listOf(29, 17)),
            Pair(1280 to 800, listOf(45, 37)),
            Pair(1440 to 900, listOf(47, 42)),
            Pair(1920 to 1080, listOf(42, 47)),
        )
    }
}
