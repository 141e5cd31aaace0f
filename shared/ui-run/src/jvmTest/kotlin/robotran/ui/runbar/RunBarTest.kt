package robotran.ui.runbar

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsEnabled
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.requestFocus
import robotran.brick.kind.BrickKind
import robotran.runcontrol.RunSpeed
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.assertUnmoved
import robotran.ui.screen.checkTargets
import robotran.ui.screen.onPhone
import robotran.ui.screen.onScreen
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.placesByTag
import robotran.uikit.*
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class RunBarTest {
    @Test
    fun `Pause lets the robot stand still and becomes Go on`() = onTablet { workshop ->
        onNodeWithTag(RunTags.PAUSE).assertIsNotEnabled()
        onNodeWithTag(RunTags.RUN).performClick()
        pass(500)
        onNodeWithTag(RunTags.PAUSE).assertIsEnabled().performClick()
        pass(100)
        val time = workshop.state.run.time
        pass(500)
        assertEquals(time, workshop.state.run.time)
        onNodeWithTag(RunTags.STATUS).assertTextContains("Paused at line", substring = true)
        onNodeWithTag(RunTags.PAUSE).performClick()
        pass(500)
        assertTrue(workshop.state.run.time > time)
    }

    @Test
    fun `Step goes through the program line by line`() = onTablet { workshop ->
        onNodeWithTag(RunTags.STEP).performClick()
        pass(100)
        val first = workshop.state.shownProgramRun.runningLine
        onNodeWithTag(RunTags.STEP).performClick()
        pass(2_000)
        assertTrue(workshop.state.shownProgramRun.runningLine > first)
        assertTrue(workshop.state.run.isPaused)
    }

    @Test
    fun `other steps are in a menu beside it`() = onTablet { workshop ->
        onNodeWithTag(RunTags.STEP).performClick()
        pass(100)
        onNodeWithTag(RunTags.STEPS).performClick()
        pass(500)
        for (tag in listOf(
            RunTags.STEP_INTO,
            RunTags.STEP_OVER,
            RunTags.STEP_OUT,
            RunTags.STEP_TO_LINE,
        )) {
            onNodeWithTag(tag).assertIsDisplayed()
        }
        onNodeWithTag(RunTags.STEP_OVER).performClick()
        pass(2_000)
        assertTrue(workshop.state.run.isPaused)
        assertEquals(0, onAllNodesWithTag(RunTags.STEP_OVER).fetchSemanticsNodes().size)
    }

    @Test
    fun `the speed is chosen by its name`() = onTablet { workshop ->
        onNodeWithTag(RunTags.SPEED).performClick()
        pass(500)
        onNodeWithTag(RunTags.speed(RunSpeed.FIVEFOLD)).performClick()
        pass(300)
        assertEquals(RunSpeed.FIVEFOLD, workshop.state.run.speed)
    }

    @Test
    fun `no speed moves what stands in the bar`() {
        for ((width, height) in listOf(1180 to 820, 820 to 1180, 1366 to 768, 1600 to 900)) {
            onScreen(width, height) { workshop ->
                pass(300)
                val before = placesByTag()
                for (speed in RunSpeed.entries) {
                    workshop.handle(RunEvent.SpeedChosen(speed))
                    pass(300)
                    val tags =
                        listOf(
                            RunTags.RUN,
                            RunTags.PAUSE,
                            RunTags.STEP,
                            RunTags.STOP,
                            RunTags.SPEED,
                            RunTags.RUN_MORE,
                            RunTags.SOUND,
                        )
                    // Held upright, a tablet has the speed in its panel.
                    assertUnmoved(before, tags.filter { it != "speed" || width > height }, "$width x $height at $speed")
                }
            }
        }
    }

    @Test
    fun `a touch on the timeline goes there, and the arrow keys go on from there`() = onTablet { workshop ->
        onNodeWithTag(RunTags.RUN).performClick()
        pass(9_000)
        val length = workshop.state.run.length
        onNodeWithTag(RunTags.TIMELINE).performTouchInput { click(Offset(width * 0.5f, height * 0.6f)) }
        pass(1_000)
        val time = workshop.state.run.time
        assertTrue(time in length / 3..length * 2 / 3, "at $time of $length")
        assertEquals(time, workshop.state.session.milliseconds)
        onNodeWithTag(RunTags.TIMELINE).requestFocus()
        onNodeWithTag(RunTags.TIMELINE).performKeyInput { pressKey(Key.DirectionLeft) }
        pass(500)
        assertEquals(time - 100, workshop.state.session.milliseconds)
        onNodeWithTag(RunTags.TIMELINE).performKeyInput { pressKey(Key.MoveHome) }
        pass(500)
        assertEquals(0, workshop.state.session.milliseconds)
        onNodeWithTag(RunTags.CLOCK).assertTextEquals("0.0 s of ${oneDecimal(length / 1_000.0)} s")
    }

    @Test
    fun `a drag along the timeline takes the robot with it`() = onTablet { workshop ->
        onNodeWithTag(RunTags.RUN).performClick()
        pass(9_000)
        val length = workshop.state.run.length
        onNodeWithTag(RunTags.TIMELINE).performTouchInput {
            down(Offset(width * 0.9f, height * 0.6f))
            for (step in 1..8) moveTo(Offset(width * (0.9f - step * 0.1f), height * 0.6f))
            up()
        }
        pass(1_000)
        assertTrue(workshop.state.run.time < length / 4)
        assertEquals(workshop.state.run.time, workshop.state.session.milliseconds)
    }

    @Test
    fun `what has happened can be gone to, one after the other`() = onTablet { workshop ->
        onNodeWithTag(RunTags.RUN).performClick()
        pass(9_000)
        onNodeWithTag(RunTags.MARK_PREVIOUS).performClick()
        pass(500)
        val mark = workshop.state.run.marks.last { it.milliseconds < workshop.state.run.length }
        assertEquals(mark.milliseconds, workshop.state.run.time)
        onNodeWithTag(RunTags.MARK_NEXT).performClick()
        pass(500)
        assertTrue(workshop.state.run.time > mark.milliseconds)
    }

    @Test
    fun `a screen reader hears where the timeline is and can set it`() = onTablet { workshop ->
        onNodeWithTag(RunTags.RUN).performClick()
        pass(3_000)
        val config = onNodeWithTag(RunTags.TIMELINE).fetchSemanticsNode().config
        assertTrue("seconds" in config[SemanticsProperties.StateDescription])
        onNodeWithTag(RunTags.TIMELINE).performSemanticsAction(SemanticsActions.SetProgress) { it(1_000f) }
        pass(500)
        assertEquals(1_000, workshop.state.session.milliseconds)
    }

    @Test
    fun `a phone keeps Run, Pause, Step and Stop, and has the rest behind one button`() = onPhone { workshop ->
        checkTargets(RunTags.RUN, RunTags.PAUSE, RunTags.STEP, RunTags.STOP, RunTags.RUN_MORE)
        onNodeWithTag(RunTags.RUN_MORE).performClick()
        pass(500)
        onNodeWithTag(RunTags.RUN_PANEL).assertIsDisplayed()
        onNodeWithTag(RunTags.panelSpeed(RunSpeed.DOUBLE)).performClick()
        pass(200)
        assertEquals(RunSpeed.DOUBLE, workshop.state.run.speed)
        onNodeWithTag(RunTags.RUN_PANEL_CLOSE).performClick()
        pass(500)
        assertEquals(0, onAllNodesWithTag(RunTags.RUN_PANEL).fetchSemanticsNodes().size)
    }

    @Test
    fun `with text of twice the size nothing of the bar is lost`() {
        onPhone { workshop -> largeText(workshop::handle) }
        onTablet { workshop -> largeText(workshop::handle) }
    }

    private fun ComposeUiTest.largeText(handle: (WorkshopEvent) -> Unit) {
        handle(SettingsEvent.SettingsChanged(Settings(textScale = 2f)))
        handle(RunEvent.RunPressed)
        pass(500)
        checkTargets(
            RunTags.RUN,
            RunTags.PAUSE,
            RunTags.STEP,
            RunTags.STOP,
            RunTags.RUN_MORE,
            RunTags.TIMELINE,
            RunTags.MARK_PREVIOUS,
            RunTags.MARK_NEXT,
        )
    }

    @Test
    fun `what forgiving Java does on an NXT is told where it is chosen`() = onTablet { workshop ->
        val described = mapOf(BrickKind.RCX to "quirks of a real brick", BrickKind.NXT to "run only here")
        for ((brick, words) in described) {
            workshop.handle(WorldEditEvent.PenbotChosen(workshop.state.programs.shownRobot, brick))
            pass(300)
            onNodeWithTag(RunTags.RUN_MORE).performClick()
            pass(500)
            onNodeWithTag(RunTags.JAVA_FORGIVING).assertTextContains(words, substring = true)
            onNodeWithTag(RunTags.RUN_PANEL_CLOSE).performClick()
            pass(500)
        }
    }

    @Test
    fun `realism and chance are in the panel`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited("beep"))
        onNodeWithTag(RunTags.RUN_MORE).performClick()
        pass(500)
        onNodeWithTag(RunTags.REALISM).performSemanticsAction(SemanticsActions.SetProgress) { it(0.5f) }
        pass(200)
        assertEquals(0.5, workshop.state.world.realism)
        val seed = workshop.state.world.seed
        workshop.handle(RunEvent.RunSettingsChanged(workshop.state.run.settings.copy(seed = seed + 1)))
        pass(200)
        assertEquals(seed + 1, workshop.state.world.seed)
    }
}
