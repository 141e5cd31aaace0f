package robotran.ui.screen

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
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
        for ((size, now) in SHARES) {
            for ((number, scale) in SCALES.withIndex()) {
                onWindow(size, Settings(textScale = scale, lessMotion = true)) { _ ->
                    val described = "${size.first} x ${size.second}, text $scale"
                    assertEquals(now[number], shareOf(WorldTags.WORLD, size), "$described, in percent")
                }
            }
        }
    }

    @Test
    fun `the sheet has more room than any other pane`() {
        for (size in SHARES.map { it.first }) {
            onWindow(size, Settings(lessMotion = true)) {
                for (tag in listOf("program", "brick").filter { isThere(it) }) {
                    assertTrue(shareOf(WorldTags.WORLD, size) > shareOf(tag, size), "$size: $tag has more")
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
            Pair(360 to 640, listOf(55, 48)),
            Pair(411 to 891, listOf(67, 63)),
            Pair(640 to 360, listOf(40, 37)),
            Pair(891 to 411, listOf(50, 47)),
            Pair(820 to 1180, listOf(39, 27)),
            Pair(1280 to 800, listOf(52, 46)),
            Pair(1440 to 900, listOf(53, 51)),
            Pair(1920 to 1080, listOf(42, 55)),
        )
    }
}
