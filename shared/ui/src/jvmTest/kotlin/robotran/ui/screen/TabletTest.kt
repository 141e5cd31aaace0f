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
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.world.tags.WorldTags
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class TabletTest {
    @Test
    fun `the first screen shows program, world and the small brick`() = onTablet {
        for (tag in listOf(
            ProgramTags.PROGRAM,
            WorldTags.WORLD,
            RunTags.button(BrickButton.RUN),
            RunTags.RUN,
            RunTags.STOP,
            RunTags.LCD,
        )) {
            onNodeWithTag(tag).assertIsDisplayed()
        }
        onNodeWithTag(ProgramTags.PROGRAM).assertTextContains("forward 20", substring = true)
        onNodeWithTag(RunTags.STATUS).assertTextEquals("Ready. Press Run.")
        onNodeWithTag(RunTags.STOP).assertIsNotEnabled()
        onNodeWithTag(RunTags.LCD).assertContentDescriptionContains("Display: 9.0 0, standing man")
    }

    @Test
    fun `pressing Run on the brick and letting go makes the robot draw`() = onTabletWithBrick { workshop ->
        onNodeWithTag(RunTags.button(BrickButton.RUN)).performTouchInput { down(center) }
        pass(300)
        assertFalse(workshop.state.running)
        assertEquals(setOf(BrickButton.RUN), workshop.state.session.brick.pressed)
        onNodeWithTag(RunTags.button(BrickButton.RUN)).performTouchInput { up() }
        pass(800)
        assertTrue(workshop.state.running)
        assertTrue(workshop.state.session.ink.lengthCentimetres > 5)
        onNodeWithTag(WorldTags.WORLD).assertContentDescriptionContains("pen down", substring = true)
        onNodeWithTag(RunTags.port("A")).assertContentDescriptionContains("Motor A forward, power 3")
        onNodeWithTag(RunTags.STOP).assertIsEnabled()
    }

    @Test
    fun `the square is drawn to its end and then everything rests`() = onTablet { workshop ->
        onNodeWithTag(RunTags.RUN).performClick()
        pass(10_000)
        assertEquals(RunState.Ended(stopped = false), workshop.state.session.brick.run)
        onNodeWithTag(RunTags.STATUS).assertTextEquals("Done")
        val rested = workshop.state.session.milliseconds
        pass(2_000)
        assertEquals(rested, workshop.state.session.milliseconds)
        mainClock.autoAdvance = true
        waitForIdle()
    }

    @Test
    fun `Stop stops`() = onTablet { workshop ->
        onNodeWithTag(RunTags.RUN).performClick()
        pass(1500)
        onNodeWithTag(RunTags.STOP).performClick()
        pass(300)
        onNodeWithTag(RunTags.STATUS).assertTextEquals("Stopped")
        val ink = workshop.state.session.ink.lengthCentimetres
        pass(2000)
        assertEquals(ink, workshop.state.session.ink.lengthCentimetres, absoluteTolerance = 0.01)
    }

    @Test
    fun `a mistake is shown with its line, nothing runs, and a touch mends it`() = onTablet { workshop ->
        onNodeWithTag(ProgramTags.PROGRAM).performTextReplacement("pen down\nforwrd 20\n")
        pass(100)
        onNodeWithText("Line 2:", substring = true).assertIsDisplayed()
        onNodeWithTag(RunTags.RUN).performClick()
        pass(1000)
        assertEquals(RunState.Idle, workshop.state.session.brick.run)
        onNodeWithTag(RunTags.STATUS).assertTextEquals("Fix line 2 first.")
        onNodeWithTag(ProgramTags.FIX).performClick()
        pass(100)
        onNodeWithTag(ProgramTags.PROGRAM).assertTextContains("forward 20", substring = true)
        assertEquals(0, onAllNodesWithTag(ProgramTags.MISTAKES).fetchSemanticsNodes().size)
        onNodeWithTag(RunTags.RUN).performClick()
        pass(1000)
        assertTrue(workshop.state.running)
    }

    @Test
    fun `two fingers hold Run and press On-Off, which ends the program`() = onTabletWithBrick { workshop ->
        onNodeWithTag(RunTags.RUN).performClick()
        pass(1500)
        val run = bounds(RunTags.button(BrickButton.RUN)).center
        val onOff = bounds(RunTags.button(BrickButton.ON_OFF)).center
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
        onNodeWithTag(ProgramTags.PROGRAM).performTextReplacement("var zero = 0\nshow 5 / zero\n")
        onNodeWithTag(RunTags.RUN).performClick()
        pass(2_000)
        onNodeWithTag(RunTags.BRICK_HINT).assertTextContains("Line 2:", substring = true)
        onNodeWithTag(RunTags.BRICK_HINT).assertTextContains("Press On-Off", substring = true)
        onNodeWithTag(RunTags.button(BrickButton.ON_OFF)).performClick()
        pass(500)
        onNodeWithTag(RunTags.BRICK_HINT).assertDoesNotExist()
    }

    @Test
    fun `the names on the brick's buttons keep a margin`() = onTabletWithBrick {
        pass(300)
        for (tag in listOf(
            RunTags.button(BrickButton.VIEW),
            RunTags.button(BrickButton.ON_OFF),
            RunTags.button(BrickButton.RUN),
        )) {
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
        onNodeWithTag(RunTags.button(BrickButton.ON_OFF)).performClick()
        pass(500)
        onNodeWithTag(RunTags.BRICK_HINT).assertTextEquals("The brick is off. Press On-Off.")
        onNodeWithTag(RunTags.LCD).assertContentDescriptionContains("Display: nothing")
        onNodeWithTag(RunTags.port(1)).assertContentDescriptionContains("Sensor 1, left bumper")
        onNodeWithTag(RunTags.button(BrickButton.ON_OFF)).performClick()
        pass(500)
        assertTrue(workshop.state.session.brick.poweredOn)
        onNodeWithTag(RunTags.BRICK_HINT).assertDoesNotExist()
    }

    @Test
    fun `the ports tell what is plugged in and what it measures`() = onTabletWithBrick {
        pass(500)
        onNodeWithTag(RunTags.port(1)).assertContentDescriptionContains("Sensor 1, left bumper: 0")
        onNodeWithTag(RunTags.port(2)).assertContentDescriptionContains("Sensor 2, light sensor:", substring = true)
        onNodeWithTag(RunTags.port(3)).assertContentDescriptionContains("Sensor 3, right bumper: 0")
    }

    @Test
    fun `the display is read out whenever it changes`() = onTablet {
        assertEquals(
            LiveRegionMode.Polite,
            onNodeWithTag(RunTags.LCD).fetchSemanticsNode().config[SemanticsProperties.LiveRegion],
        )
    }

    @Test
    fun `the sound can be switched off and on`() = onTablet { workshop ->
        onNodeWithTag(RunTags.SOUND).assertIsOn().performClick()
        pass(100)
        onNodeWithTag(RunTags.SOUND).assertIsOff()
        assertFalse(workshop.state.soundOn)
        onNodeWithTag(RunTags.SOUND).performClick()
        pass(100)
        assertTrue(workshop.state.soundOn)
    }

    @Test
    fun `the brick lies beside the paper and the world is the largest pane`() = onTabletWithBrick {
        val world = bounds(WorldTags.WORLD)
        val brick = bounds(RunTags.BRICK)
        assertTrue(brick.left >= world.right, "the brick is over the paper")
        assertTrue(world.width > bounds(ProgramTags.PROGRAM).width && world.width > brick.width)
    }

    @Test
    fun `everything that can be pressed is large enough for a finger`() = onTabletWithBrick {
        onNodeWithTag(ProgramTags.PROGRAM).performTextReplacement("forwrd 20")
        pass(1_000)
        for (tag in listOf(
            RunTags.RUN,
            RunTags.STOP,
            RunTags.SOUND,
            ProgramTags.FIX,
            RunTags.button(BrickButton.RUN),
            RunTags.button(BrickButton.VIEW),
            RunTags.button(BrickButton.PRGM),
            RunTags.button(BrickButton.ON_OFF),
        )) {
            val place = onAllNodesWithTag(tag).onFirst().fetchSemanticsNode().touchBoundsInRoot
            assertTrue(place.width >= 48f && place.height >= 48f, "$tag is only ${place.size}")
        }
    }

    private fun ComposeUiTest.bounds(tag: String): Rect = onNodeWithTag(tag).fetchSemanticsNode().boundsInRoot
}
