package robotran.ui.screen

import androidx.compose.ui.graphics.PixelMap
import androidx.compose.ui.graphics.toPixelMap
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.captureToImage
import androidx.compose.ui.test.isFocused
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.swipeUp
import robotran.projects.ProgramView
import robotran.robolang.words.BlockGroup
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.tags.ScreenTags
import robotran.uikit.*
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Pane
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** A ring around what has the focus comes with keys only. */
@OptIn(ExperimentalTestApi::class)
class FocusRingTest {
    @Test
    fun `Run looks after a touch as it did before it`() = onTablet {
        val before = pixelsOf(RunTags.RUN)
        onNodeWithTag(RunTags.RUN).performClick()
        pass(300)
        onNodeWithTag(RunTags.STOP).performClick()
        pass(1_000)
        assertNoRing("after Run and Stop")
        assertEquals(before[4, 24], pixelsOf(RunTags.RUN)[4, 24])
    }

    @Test
    fun `nothing that a finger touches in a program keeps a ring`() = onPhone { workshop ->
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        for (tag in listOf(
            ScreenTags.tab(Pane.PROGRAM),
            ProgramTags.BLOCKS_ADD,
            ProgramTags.group(BlockGroup.PEN),
            ProgramTags.BLOCK_SHEET_CLOSE,
        )) {
            onNodeWithTag(tag).performClick()
            pass(600)
            assertNoRing("after $tag")
        }
    }

    @Test
    fun `a map of lessons that was scrolled with a finger has no ring, and one at the lesson that Tab leads to`() =
        onTablet { workshop ->
            workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
            pass(600)
            onNodeWithTag(LearningTags.MAP).performTouchInput { swipeUp(centerY, centerY - 100) }
            pass(1_000)
            assertNoRing("after a swipe")
            repeat(3) {
                onRoot().performKeyInput { pressKey(Key.Tab) }
                pass(100)
            }
            assertRing("after Tab")
        }

    @Test
    fun `the ring of the blocks goes with a touch and comes back with the next key`() = onTablet { workshop ->
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        pass(300)
        val pane = onNodeWithTag(ProgramTags.BLOCK_PANE).fetchSemanticsNode().boundsInRoot
        onNodeWithTag(ProgramTags.block("0")).performClick()
        pass(600)
        assertFalse(shown().hasDown(pane.left, pane.bottom - 20), "A ring after a touch")
        onRoot().performKeyInput { pressKey(Key.DirectionDown) }
        pass(300)
        assertTrue(shown().hasDown(pane.left, pane.bottom - 20), "No ring after a key")
    }

    @Test
    fun `a ring is whole at the edge of a phone, of a row and of a list`() = onPhone { workshop ->
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        pass(300)
        val whole = (1..STEPS).count { step ->
            onRoot().performKeyInput { pressKey(Key.Tab) }
            pass(60)
            val focused = onAllNodes(isFocused()).fetchSemanticsNodes().single()
            val place = focused.boundsInRoot
            val screen = shown()
            val sides = listOf(
                "left" to (screen.hasDown(place.left, place.center.y)),
                "right" to (screen.hasDown(place.right, place.center.y)),
                "upper" to (screen.hasAcross(place.center.x, place.top)),
                "lower" to (screen.hasAcross(place.center.x, place.bottom)),
            )
            if (sides.none { it.second }) return@count false
            for ((side, isThere) in sides) {
                assertTrue(isThere, "Step $step: no $side side of the ring at $place, ${focused.config}")
            }
            true
        }
        assertTrue(whole > STEPS / 2, "Only $whole of $STEPS had a ring")
    }

    private fun ComposeUiTest.assertNoRing(described: String) =
        assertEquals(emptyList(), shown().lines(), "A ring $described")

    private fun ComposeUiTest.assertRing(described: String) = assertTrue(shown().lines().size > 2, "No ring $described")

    private fun ComposeUiTest.shown(): PixelMap = drawn {
        pass(1)
        onRoot().captureToImage().toPixelMap()
    }

    /** Where lines of a ring begin that are longer than a stroke of any letter. */
    private fun PixelMap.lines(): List<Pair<Int, Int>> = buildList {
        for (y in 0..<height) {
            for (x in 0..<width - LINE step LINE / 2) {
                if ((x..<x + LINE).all { this@lines[it, y] == RING }) add(x to y)
            }
        }
    }

    /** Whether the ring goes down beside [x] at [y]. */
    private fun PixelMap.hasDown(x: Float, y: Float): Boolean =
        near(x, width, REACH).any { at -> near(y, height, ALONG).all { this[at, it] == RING } }

    /** Whether the ring goes across beside [y] at [x]. */
    private fun PixelMap.hasAcross(x: Float, y: Float): Boolean =
        near(y, height, REACH).any { at -> near(x, width, ALONG).all { this[it, at] == RING } }

    private fun near(at: Float, end: Int, reach: Int) =
        (at.toInt() - reach).coerceAtLeast(0)..(at.toInt() + reach).coerceAtMost(end - 1)

    private companion object {
        const val STEPS = 25

        /** A chip has its ring around all that a finger can touch. */
        const val REACH = 14
        const val ALONG = 6
        const val LINE = 24
        val RING = RobotranColours.LIGHT.focus
    }
}
