package robotran.ui.documents

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.performTextReplacement
import kotlinx.coroutines.runBlocking
import robotran.ui.school.tags.DocumentTags
import robotran.ui.screen.onPhone
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pass
import robotran.ui.screen.tags.ScreenTags
import robotran.workshop.documents.Machine
import robotran.workshop.documents.write
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.MemoryStore
import robotran.workshop.settings.SettingsStateHolder
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Sharing without a page of the app: on the desktop and on Android. */
@OptIn(ExperimentalTestApi::class)
class SiteAddressSettingTest {
    @Test
    fun `without an address of a site the file is offered and no link that leads nowhere`() = onPhone { workshop ->
        workshop.handle(DocumentEvent.LinkRequested)
        pass(200)
        onNodeWithTag(DocumentTags.SHARE_SAVE_AS).assertIsDisplayed()
        for (tag in listOf(
            DocumentTags.QR_CODE,
            DocumentTags.LINK_TEXT,
            DocumentTags.LINK_COPY,
            DocumentTags.LINK_SHARE,
        )) {
            onNodeWithTag(tag).assertDoesNotExist()
        }
        onNodeWithTag(DocumentTags.SHARE_SITE).performClick()
        // The page scrolls to the field at its end.
        pass(1_000)
        onNodeWithTag(ScreenTags.SITE).assertIsDisplayed().assertIsFocused()
        onNodeWithTag(ScreenTags.SITE).performTextInput("school.example")
        onNodeWithTag(ScreenTags.SITE_WRONG, useUnmergedTree = true).assertTextContains("https://", substring = true)
        assertEquals("", workshop.state.settings.site)
        onNodeWithTag(ScreenTags.SITE).performTextReplacement(" https://school.example/robotran/#p=a1 ")
        onNodeWithTag(ScreenTags.SITE_WRONG, useUnmergedTree = true).assertDoesNotExist()
        workshop.handle(SettingsEvent.SettingsShown(false))
        workshop.handle(DocumentEvent.LinkRequested)
        pass(200)
        val link = checkNotNull(assertIs<DocumentDialog.SharingLink>(workshop.state.document.dialog).link)
        assertTrue(link.startsWith("https://school.example/robotran/#p=a"), link)
        onNodeWithTag(DocumentTags.QR_CODE).assertExists()
        workshop.handle(SettingsEvent.SettingsShown(true))
        workshop.handle(DocumentEvent.DialogClosed)
        pass(200)
        onNodeWithTag(ScreenTags.SITE).performTextReplacement("")
        assertEquals("", workshop.state.settings.site)
    }

    @Test
    fun `a link that begins with localhost says that it works on this machine only`() {
        for ((page, isLocal) in listOf("http://localhost:8282/" to true, "https://school.example/" to false)) {
            val workshop = Machine().also { it.page = page }.window()
            onScreenOf(workshop, 411, 891) {
                workshop.handle(DocumentEvent.LinkRequested)
                pass(200)
                if (isLocal) {
                    onNodeWithTag(DocumentTags.LINK_LOCAL).assertTextContains("localhost:8282", substring = true)
                } else {
                    onNodeWithTag(DocumentTags.LINK_LOCAL).assertDoesNotExist()
                }
            }
        }
    }

    @Test
    fun `an app that belongs to a page asks for no address`() {
        val workshop = Machine().window()
        assertTrue(workshop.state.hasPage)
        workshop.close()
        val other = Machine().also { it.page = "" }.window()
        assertFalse(other.state.hasPage)
        other.close()
    }

    @Test
    fun `what was kept is the address again, unless it cannot be one`() = runBlocking {
        for ((kept, read) in listOf(
            "https://school.example/" to "https://school.example/",
            "javascript:alert(1)" to "",
        )) {
            val store = MemoryStore()
            store.write("settings", """{"site": "$kept"}""")
            assertEquals(Settings(site = read), SettingsStateHolder.readFrom(MemoryPlatform(store = store).store))
        }
    }
}
