package robotran.ui.screen

import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.hasAnyAncestor
import androidx.compose.ui.test.hasClickAction
import androidx.compose.ui.test.hasTestTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.language.Language
import robotran.ui.school.tags.DocumentTags
import robotran.ui.screen.tags.ScreenTags
import robotran.workshop.documents.Machine
import robotran.workshop.documents.projectFile
import robotran.workshop.event.SettingsEvent
import robotran.workshop.platform.OpenRequest
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
                open(ScreenTags.MENU)
                for (item in MAIN) assertWhole(item, "$language")
                assertEquals(0f, hiddenBelow(), "$language")
                assertFalse(saysThereIsMore(ScreenTags.MENU_ITEMS), "$language")
                open(DocumentTags.WORK_MENU)
                for (item in WORK) assertWhole(DocumentTags.menuItem(item), "$language")
                assertEquals(0f, hiddenBelow(), "$language")
                open(DocumentTags.menuItem(DocumentTags.MORE))
                for (item in MORE) assertWhole(DocumentTags.menuItem(item), "$language")
                assertEquals(0f, hiddenBelow(), "$language")
            }
        }
    }

    @Test
    fun `what can be done with the work is a list of its own, with a way back`() = onScreen(412, 915) { workshop ->
        open(ScreenTags.MENU)
        onNodeWithTag(DocumentTags.WORK_MENU).assertTextContains("Work: My first work", substring = true)
        assertFalse(isThere(DocumentTags.menuItem(DocumentTags.NEW)))
        open(DocumentTags.WORK_MENU)
        assertFalse(isThere(ScreenTags.MENU_SETTINGS))
        open(ScreenTags.MENU_BACK)
        assertFalse(isThere(DocumentTags.menuItem(DocumentTags.NEW)))
        open(DocumentTags.WORK_MENU)
        open(DocumentTags.menuItem(DocumentTags.RENAME))
        assertNotNull(workshop.state.document.dialog)
        assertFalse(isThere(ScreenTags.MENU_ITEMS))
    }

    @Test
    fun `a menu that is too long shows that there is more, as far as there is`() {
        for ((width, height, scale) in listOf(Triple(412, 915, 2f), Triple(891, 411, 1f), Triple(891, 411, 2f))) {
            onScreen(width, height) { workshop ->
                workshop.handle(SettingsEvent.SettingsChanged(Settings(textScale = scale)))
                pass(300)
                open(ScreenTags.MENU)
                checkHint(ScreenTags.MENU_TEACHERS, isLow = height < width)
                scroll(ScreenTags.MENU_ITEMS, toEnd = false)
                open(DocumentTags.WORK_MENU)
                checkHint(DocumentTags.menuItem(DocumentTags.MORE), isLow = height < width)
            }
        }
    }

    @Test
    fun `no list of the menus has more than nine entries, with a file and a brick to send to`() {
        val file = OpenRequest.OfFiles(listOf(projectFile("beep")))
        for ((width, height) in listOf(412 to 915, 1280 to 800)) {
            onScreenOf(Machine().window(file), width, height) {
                pass(600)
                if (!isThere(DocumentTags.WORK_MENU)) {
                    open(ScreenTags.MENU)
                    assertFew()
                }
                open(DocumentTags.WORK_MENU)
                assertTrue(isThere(DocumentTags.menuItem(DocumentTags.SAVE)))
                assertFew()
                open(DocumentTags.menuItem(DocumentTags.MORE))
                assertFew()
            }
        }
    }

    @Test
    fun `a world and a robot are built from a list of the menu`() = onScreen(412, 915) { workshop ->
        open(ScreenTags.MENU)
        open(ScreenTags.MENU_BUILD)
        assertTrue(isThere(ScreenTags.MENU_BUILD_ROBOT))
        open(ScreenTags.MENU_BACK)
        open(ScreenTags.MENU_BUILD)
        open(ScreenTags.MENU_EDIT_WORLD)
        assertNotNull(workshop.state.worldEdit)
    }

    /** Every entry of an open menu is pressed by itself. The way back is none. */
    private fun ComposeUiTest.assertFew() {
        val entries = onAllNodes(isInMenu and hasClickAction() and !isWayBack).fetchSemanticsNodes().size
        assertTrue(entries in 2..MOST, "$entries entries")
    }

    private fun ComposeUiTest.checkHint(last: String, isLow: Boolean) {
        if (isLow) assertTrue(hiddenBelow() > 0, "all is in sight")
        assertEquals(hiddenBelow() > 0, saysThereIsMore(ScreenTags.MENU_ITEMS), "whether there is more is not told")
        scroll(ScreenTags.MENU_ITEMS, toEnd = true)
        assertWhole(last, "at the end")
        assertFalse(saysThereIsMore(ScreenTags.MENU_ITEMS), "there is no more")
    }

    private fun ComposeUiTest.open(tag: String) {
        onNodeWithTag(tag).performClick()
        pass(600)
    }

    private fun ComposeUiTest.hiddenBelow(): Float {
        val scrolled = onNodeWithTag(ScreenTags.MENU_ITEMS)
            .fetchSemanticsNode().config[SemanticsProperties.VerticalScrollAxisRange]
        return scrolled.maxValue() - scrolled.value()
    }

    private companion object {
        const val MOST = 9
        val isWayBack = hasTestTag(ScreenTags.MENU_BACK) or hasTestTag(DocumentTags.menuItem(DocumentTags.LESS))
        val isInMenu = hasAnyAncestor(hasTestTag(ScreenTags.MENU_ITEMS) or hasTestTag(DocumentTags.WORK_MENU_ITEMS))
        val MAIN = listOf(
            DocumentTags.WORK_MENU,
            ScreenTags.MENU_MAP,
            ScreenTags.MENU_WORLDS,
            ScreenTags.MENU_EXAMPLES,
            ScreenTags.MENU_WORDS,
            ScreenTags.MENU_BUILD,
            ScreenTags.MENU_FIRST_PAGE,
            ScreenTags.MENU_SETTINGS,
            ScreenTags.MENU_TEACHERS,
        )
        val WORK = listOf(
            DocumentTags.NEW,
            DocumentTags.MY_WORK,
            DocumentTags.RENAME,
            DocumentTags.SHARE_LINK,
            DocumentTags.SHOW,
            DocumentTags.MORE,
        )
        val MORE = listOf(
            DocumentTags.OPEN,
            DocumentTags.OPEN_LINK,
            DocumentTags.SAVE_AS,
            DocumentTags.REPLAY,
            DocumentTags.PROGRAM_FILE,
            DocumentTags.KIT,
        )
    }
}
