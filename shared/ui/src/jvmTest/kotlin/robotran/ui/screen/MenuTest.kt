package robotran.ui.screen

import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.language.Language
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class MenuTest {
    @Test
    fun `on a phone the whole menu is in sight, and so is what can be done with the work`() {
        for (language in Language.entries) {
            onScreen(412, 915) { workshop ->
                workshop.handle(SettingsEvent.SettingsChanged(Settings(language = language)))
                pass(300)
                open("menu")
                for (item in MAIN) assertWhole(item, "$language")
                assertEquals(0f, hiddenBelow(), "$language")
                assertFalse(saysThereIsMore("menu-items"), "$language")
                open("work-menu")
                for (item in WORK) assertWhole("work-$item", "$language")
                assertEquals(0f, hiddenBelow(), "$language")
            }
        }
    }

    @Test
    fun `what can be done with the work is a list of its own, with a way back`() = onScreen(412, 915) { workshop ->
        open("menu")
        onNodeWithTag("work-menu").assertTextContains("Work: My first work", substring = true)
        assertFalse(isThere("work-new"))
        open("work-menu")
        assertFalse(isThere("menu-settings"))
        open("menu-back")
        assertFalse(isThere("work-new"))
        open("work-menu")
        open("work-rename")
        assertNotNull(workshop.state.document.dialog)
        assertFalse(isThere("menu-items"))
    }

    @Test
    fun `a menu that is too long shows that there is more, as far as there is`() {
        for ((width, height, scale) in listOf(Triple(412, 915, 2f), Triple(891, 411, 1f), Triple(891, 411, 2f))) {
            onScreen(width, height) { workshop ->
                workshop.handle(SettingsEvent.SettingsChanged(Settings(textScale = scale)))
                pass(300)
                open("menu")
                checkHint("menu-settings", isLow = height < width)
                scroll("menu-items", toEnd = false)
                open("work-menu")
                checkHint("work-kit", isLow = height < width)
            }
        }
    }

    private fun ComposeUiTest.checkHint(last: String, isLow: Boolean) {
        if (isLow) assertTrue(hiddenBelow() > 0, "all is in sight")
        assertEquals(hiddenBelow() > 0, saysThereIsMore("menu-items"), "whether there is more is not told")
        scroll("menu-items", toEnd = true)
        assertWhole(last, "at the end")
        assertFalse(saysThereIsMore("menu-items"), "there is no more")
    }

    private fun ComposeUiTest.open(tag: String) {
        onNodeWithTag(tag).performClick()
        pass(600)
    }

    private fun ComposeUiTest.hiddenBelow(): Float {
        val scrolled = onNodeWithTag(
            "menu-items",
        ).fetchSemanticsNode().config[SemanticsProperties.VerticalScrollAxisRange]
        return scrolled.maxValue() - scrolled.value()
    }

    private companion object {
        val MAIN = listOf(
            "work-menu",
            "menu-learn",
            "menu-worlds",
            "menu-examples",
            "menu-words",
            "menu-edit-world",
            "menu-first-page",
            "menu-sound",
            "menu-settings",
        )
        val WORK = listOf(
            "new",
            "my-work",
            "open",
            "open-link",
            "rename",
            "save-as",
            "share-link",
            "show",
            "replay",
            "program-file",
            "kit",
        )
    }
}
