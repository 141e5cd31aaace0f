package robotran.ui.screen

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import robotran.language.Language
import robotran.ui.screen.tags.ScreenTags
import robotran.uikit.*
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class SettingsPageTest {
    @Test
    fun `Escape closes the settings after a language was chosen with a finger`() = onPhone { workshop ->
        openSettings()
        onNodeWithTag(KitTags.at(ScreenTags.LANGUAGE, 2)).performClick()
        pass(600)
        assertEquals(Language.entries[1], workshop.state.settings.language)
        escape()
        assertFalse(workshop.state.settingsShown)
    }

    @Test
    fun `Escape closes the settings after languages and colours were chosen with a mouse`() = onTablet { workshop ->
        openSettings()
        for (choice in listOf(
            KitTags.at(ScreenTags.LANGUAGE, 2),
            KitTags.at(ScreenTags.THEME, 1),
            KitTags.at(ScreenTags.LANGUAGE, 3),
            KitTags.at(ScreenTags.LANGUAGE, 0),
        )) {
            onNodeWithTag(choice).performMouseInput { click() }
            pass(600)
        }
        assertTrue(workshop.state.settingsShown)
        escape()
        assertFalse(workshop.state.settingsShown)
    }

    @Test
    fun `the size of texts follows a finger to the end, and is chosen when it is lifted`() =
        onScreen(411, 1500) { workshop ->
            openSettings()
            onNodeWithTag(ScreenTags.TEXT_SIZE).performTouchInput {
                // Not at the very edge, which is not the slider's.
                down(percentOffset(0.1f, 0.5f))
                for (step in 2..10) moveTo(percentOffset(step / 10f, 0.5f))
            }
            pass(300)
            val shown = onNodeWithTag(ScreenTags.TEXT_SIZE)
                .fetchSemanticsNode().config[SemanticsProperties.StateDescription]
            assertEquals("200 %", shown)
            assertEquals(1f, workshop.state.settings.textScale)
            onNodeWithTag(ScreenTags.TEXT_SIZE).performTouchInput { up() }
            pass(300)
            assertEquals(2f, workshop.state.settings.textScale)
        }

    private fun ComposeUiTest.openSettings() {
        for (tag in listOf(ScreenTags.MENU, ScreenTags.MENU_SETTINGS)) {
            onNodeWithTag(tag).performClick()
            pass(600)
        }
    }

    private fun ComposeUiTest.escape() {
        onRoot().performKeyInput { pressKey(Key.Escape) }
        pass(300)
    }
}
