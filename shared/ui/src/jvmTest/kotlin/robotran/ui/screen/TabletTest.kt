package robotran.ui.screen

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.luminance
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertContentDescriptionContains
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsEnabled
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.assertIsOff
import androidx.compose.ui.test.assertIsOn
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onFirst
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.performTouchInput
import robotran.brick.controls.BrickButton
import robotran.brick.state.RunState
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class TabletTest {
    @Test
    fun `the first screen shows program, world and the small brick`() = onTablet {
        for (tag in listOf(
            "program",
            "world",
            "brick-run",
            "run",
            "stop",
            "lcd",
        )) {
            onNodeWithTag(tag).assertIsDisplayed()
        }
        onNodeWithTag("program").assertTextContains("forward 20", substring = true)
        onNodeWithTag("status").assertTextEquals("Ready. Press Run.")
        onNodeWithTag("stop").assertIsNotEnabled()
        onNodeWithTag("lcd").assertContentDescriptionContains("Display: 9.0 0, standing man")
    }

    @Test
    fun `pressing Run on the brick and letting go makes the robot draw`() = onTabletWithBrick { workshop ->
        onNodeWithTag("brick-run").performTouchInput { down(center) }
        pass(300)
        assertFalse(workshop.state.running)
        assertEquals(setOf(BrickButton.RUN), workshop.state.session.brick.pressed)
        onNodeWithTag("brick-run").performTouchInput { up() }
        pass(800)
        assertTrue(workshop.state.running)
        assertTrue(workshop.state.session.ink.lengthCentimetres > 5)
        onNodeWithTag("world").assertContentDescriptionContains("pen down", substring = true)
        onNodeWithTag("port-A").assertContentDescriptionContains("Motor A forward, power 3")
        onNodeWithTag("stop").assertIsEnabled()
    }

    @Test
    fun `the square is drawn to its end and then everything rests`() = onTablet { workshop ->
        onNodeWithTag("run").performClick()
        pass(10_000)
        assertEquals(RunState.Ended(stopped = false), workshop.state.session.brick.run)
        onNodeWithTag("status").assertTextEquals("Done")
        val rested = workshop.state.session.milliseconds
        pass(2_000)
        assertEquals(rested, workshop.state.session.milliseconds)
        mainClock.autoAdvance = true
        waitForIdle()
    }

    @Test
    fun `Stop stops`() = onTablet { workshop ->
        onNodeWithTag("run").performClick()
        pass(1500)
        onNodeWithTag("stop").performClick()
        pass(300)
        onNodeWithTag("status").assertTextEquals("Stopped")
        val ink = workshop.state.session.ink.lengthCentimetres
        pass(2000)
        assertEquals(ink, workshop.state.session.ink.lengthCentimetres, absoluteTolerance = 0.01)
    }

    @Test
    fun `a mistake is shown with its line, nothing runs, and a touch mends it`() = onTablet { workshop ->
        onNodeWithTag("program").performTextReplacement("pen down\nforwrd 20\n")
        pass(100)
        onNodeWithText("Line 2:", substring = true).assertIsDisplayed()
        onNodeWithTag("run").performClick()
        pass(1000)
        assertEquals(RunState.Idle, workshop.state.session.brick.run)
        onNodeWithTag("status").assertTextEquals("First mend line 2.")
        onNodeWithTag("fix").performClick()
        pass(100)
        onNodeWithTag("program").assertTextContains("forward 20", substring = true)
        assertEquals(0, onAllNodesWithTag("mistakes").fetchSemanticsNodes().size)
        onNodeWithTag("run").performClick()
        pass(1000)
        assertTrue(workshop.state.running)
    }

    @Test
    fun `two fingers hold Run and press On-Off, which ends the program`() = onTabletWithBrick { workshop ->
        onNodeWithTag("run").performClick()
        pass(1500)
        val run = bounds("brick-run").center
        val onOff = bounds("brick-on_off").center
        onRoot().performTouchInput { down(0, run) }
        pass(100)
        onRoot().performTouchInput { down(1, onOff) }
        pass(100)
        assertEquals(setOf(BrickButton.RUN, BrickButton.ON_OFF), workshop.state.down)
        onRoot().performTouchInput { up(1) }
        pass(100)
        onRoot().performTouchInput { up(0) }
        pass(100)
        assertEquals(RunState.Ended(stopped = true), workshop.state.session.brick.run)
        assertTrue(workshop.state.session.brick.poweredOn)
        assertEquals(emptySet(), workshop.state.down)
    }

    @Test
    fun `a program that fails is explained beside the brick until On-Off is pressed`() = onTabletWithBrick {
        onNodeWithTag("program").performTextReplacement("var zero = 0\nshow 5 / zero\n")
        onNodeWithTag("run").performClick()
        pass(2_000)
        onNodeWithTag("brick-hint").assertTextContains("Line 2:", substring = true)
        onNodeWithTag("brick-hint").assertTextContains("Press On-Off", substring = true)
        onNodeWithTag("brick-on_off").performClick()
        pass(500)
        onNodeWithTag("brick-hint").assertDoesNotExist()
    }

    @Test
    fun `the names on the brick's buttons keep a margin`() = onTabletWithBrick {
        pass(300)
        for (tag in listOf("brick-view", "brick-on_off", "brick-run")) {
            val key = pixelsOf(tag)
            val written = (0..<key.width).filter { x ->
                (key.height / 4..key.height * 3 / 4).any { y ->
                    key[x, y].luminance() > 0.7f
                }
            }
            val margin = minOf(written.first(), key.width - 1 - written.last()).toFloat() / key.width
            assertTrue(margin >= 0.1f, "$tag has a margin of $margin")
        }
    }

    @Test
    fun `a brick that is off says which button switches it on`() = onTabletWithBrick { workshop ->
        pass(1_000)
        onNodeWithTag("brick-on_off").performClick()
        pass(500)
        onNodeWithTag("brick-hint").assertTextEquals("The brick is off. Press On-Off.")
        onNodeWithTag("lcd").assertContentDescriptionContains("Display: nothing")
        onNodeWithTag("port-1").assertContentDescriptionContains("Sensor 1, left bumper")
        onNodeWithTag("brick-on_off").performClick()
        pass(500)
        assertTrue(workshop.state.session.brick.poweredOn)
        onNodeWithTag("brick-hint").assertDoesNotExist()
    }

    @Test
    fun `the ports tell what is plugged in and what it measures`() = onTabletWithBrick {
        pass(500)
        onNodeWithTag("port-1").assertContentDescriptionContains("Sensor 1, left bumper: 0")
        onNodeWithTag("port-2").assertContentDescriptionContains("Sensor 2, light sensor:", substring = true)
        onNodeWithTag("port-3").assertContentDescriptionContains("Sensor 3, right bumper: 0")
    }

    @Test
    fun `the display is read out whenever it changes`() = onTablet {
        assertEquals(
            LiveRegionMode.Polite,
            onNodeWithTag("lcd").fetchSemanticsNode().config[SemanticsProperties.LiveRegion],
        )
    }

    @Test
    fun `the sound can be switched off and on`() = onTablet { workshop ->
        onNodeWithTag("sound").assertIsOn().performClick()
        pass(100)
        onNodeWithTag("sound").assertIsOff()
        assertFalse(workshop.state.soundOn)
        onNodeWithTag("sound").performClick()
        pass(100)
        assertTrue(workshop.state.soundOn)
    }

    @Test
    fun `the brick lies beside the paper and the world is the largest pane`() = onTabletWithBrick {
        val world = bounds("world")
        val brick = bounds("brick")
        assertTrue(brick.left >= world.right, "the brick is over the paper")
        assertTrue(world.width > bounds("program").width && world.width > brick.width)
    }

    @Test
    fun `everything that can be pressed is large enough for a finger`() = onTabletWithBrick {
        onNodeWithTag("program").performTextReplacement("forwrd 20")
        pass(1_000)
        for (tag in listOf("run", "stop", "sound", "fix", "brick-run", "brick-view", "brick-prgm", "brick-on_off")) {
            val place = onAllNodesWithTag(tag).onFirst().fetchSemanticsNode().touchBoundsInRoot
            assertTrue(place.width >= 48f && place.height >= 48f, "$tag is only ${place.size}")
        }
    }

    private fun ComposeUiTest.bounds(tag: String): Rect = onNodeWithTag(tag).fetchSemanticsNode().boundsInRoot
}
