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
import robotran.ui.screen.onPhone
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pass
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
        onNodeWithTag("share-save-as").assertIsDisplayed()
        for (tag in listOf("qr-code", "link-text", "link-copy", "link-share")) onNodeWithTag(tag).assertDoesNotExist()
        onNodeWithTag("share-site").performClick()
        pass(200)
        onNodeWithTag("site").assertIsDisplayed().assertIsFocused()
        onNodeWithTag("site").performTextInput("school.example")
        onNodeWithTag("site-wrong", useUnmergedTree = true).assertTextContains("https://", substring = true)
        assertEquals("", workshop.state.settings.site)
        onNodeWithTag("site").performTextReplacement(" https://school.example/robotran/#p=a1 ")
        onNodeWithTag("site-wrong", useUnmergedTree = true).assertDoesNotExist()
        workshop.handle(SettingsEvent.SettingsShown(false))
        workshop.handle(DocumentEvent.LinkRequested)
        pass(200)
        val link = checkNotNull(assertIs<DocumentDialog.SharingLink>(workshop.state.document.dialog).link)
        assertTrue(link.startsWith("https://school.example/robotran/#p=a"), link)
        onNodeWithTag("qr-code").assertExists()
        workshop.handle(SettingsEvent.SettingsShown(true))
        workshop.handle(DocumentEvent.DialogClosed)
        pass(200)
        onNodeWithTag("site").performTextReplacement("")
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
                    onNodeWithTag("link-local").assertTextContains("localhost:8282", substring = true)
                } else {
                    onNodeWithTag("link-local").assertDoesNotExist()
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
