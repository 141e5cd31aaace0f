package robotran.ui.screen

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsEnabled
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.assertIsOn
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performScrollTo
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.withKeyDown
import robotran.runsound.SoundSample
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.Notice
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Runs can be heard: who cannot see the sheet finds the switch by touch, by keys and in the settings. */
@OptIn(ExperimentalTestApi::class)
class HearingTest {
    @Test
    fun `a key makes the run heard from inside the program, and says so`() = onTablet { workshop ->
        onNodeWithTag(ProgramTags.PROGRAM).performClick()
        onRoot().performKeyInput { withKeyDown(Key.ShiftLeft) { pressKey(Key.F6) } }
        pass(300)
        assertTrue(workshop.state.settings.hearsRun)
        assertEquals(Notice.RunHeard(on = true, isMuted = false), workshop.state.notice)
        onRoot().performKeyInput { withKeyDown(Key.ShiftLeft) { pressKey(Key.F6) } }
        pass(300)
        assertFalse(workshop.state.settings.hearsRun)
    }

    @Test
    fun `the list at the sheet has the same switch`() = onTablet { workshop ->
        onNodeWithTag(WorldTags.SHEET_SHOW).performClick()
        pass(300)
        onNodeWithTag(WorldTags.HEAR_RUN).performClick()
        pass(300)
        assertTrue(workshop.state.settings.hearsRun)
    }

    @Test
    fun `the settings have a button for each sound once it is switched on`() = onScreen(411, 3000) { workshop ->
        openSettings()
        assertEquals(0, onAllNodesWithTag(ScreenTags.sample(SoundSample.BUMP)).fetchSemanticsNodes().size)
        onNodeWithTag(ScreenTags.HEARING_SETTING).performScrollTo().performClick()
        pass(300)
        onNodeWithTag(ScreenTags.HEARING_SETTING).assertIsOn()
        assertTrue(workshop.state.settings.hearsRun)
        for (sample in SoundSample.entries) {
            onNodeWithTag(ScreenTags.sample(sample)).performScrollTo().assertIsEnabled().performClick()
        }
        workshop.handle(SettingsEvent.SoundSwitched(on = false))
        pass(300)
        onNodeWithTag(ScreenTags.sample(SoundSample.BUMP)).assertIsNotEnabled()
    }

    private fun ComposeUiTest.openSettings() {
        for (tag in listOf(ScreenTags.MENU, ScreenTags.MENU_SETTINGS)) {
            onNodeWithTag(tag).performClick()
            pass(600)
        }
    }
}
