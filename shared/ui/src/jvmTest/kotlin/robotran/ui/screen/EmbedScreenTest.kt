package robotran.ui.screen

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsEnabled
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import kotlinx.coroutines.runBlocking
import org.jetbrains.skia.EncodedImageFormat
import robotran.language.Language
import robotran.ui.RobotranApp
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import java.io.File
import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class EmbedScreenTest {
    @Test
    fun `a page's part has world and brick, and nothing to write in`() = embedded(800, 500) {
        for (tag in listOf(
            "world",
            "brick",
            "run",
            "stop",
            "start-over",
            "status",
        )) {
            onNodeWithTag(tag).assertIsDisplayed()
        }
        for (tag in listOf(
            "program",
            "menu",
            "work-menu",
            "learn",
            "edit-world",
        )) {
            onNodeWithTag(tag).assertDoesNotExist()
        }
    }

    @Test
    fun `it runs, stops and goes back to the start`() = embedded(800, 500) { workshop ->
        onNodeWithTag("start-over").assertIsNotEnabled()
        onNodeWithTag("run").performClick()
        pass(500)
        assertTrue(workshop.state.running)
        onNodeWithTag("stop").assertIsEnabled().performClick()
        pass(300)
        assertFalse(workshop.state.running)
        assertTrue(workshop.state.session.ink.lengthCentimetres > 0)
        onNodeWithTag("start-over").performClick()
        pass(300)
        assertTrue(workshop.state.session.ink.lengthCentimetres == 0.0)
    }

    @Test
    fun `where there is little room the brick shrinks to its display and Run`() = embedded(320, 420) {
        onNodeWithTag("brick").assertDoesNotExist()
        for (tag in listOf(
            "world",
            "lcd",
            "brick-run",
            "run",
            "stop",
            "start-over",
        )) {
            onNodeWithTag(tag).assertIsDisplayed()
        }
    }

    @Test
    fun `a link that cannot be used is told in a sentence instead`() = embedded(800, 500) { workshop ->
        workshop.handle(DocumentEvent.LinkOpened("#p=aXXXX"))
        pass(200)
        onNodeWithTag("document-trouble").assertIsDisplayed()
        onNodeWithTag("run").assertDoesNotExist()
    }

    @Test
    fun `pictures can be taken of it`() {
        val folder = File(System.getProperty("robotran.pictures")).apply { mkdirs() }
        for ((width, height) in listOf(800 to 500, 320 to 420, 1280 to 800, 411 to 891)) {
            photograph(File(folder, "embed-$width-light.png"), width, height, dark = false, textScale = 1f)
            photograph(File(folder, "embed-$width-dark.png"), width, height, dark = true, textScale = 1f)
            photograph(File(folder, "embed-$width-german-200.png"), width, height, dark = false, textScale = 2f)
        }
    }

    private fun photograph(file: File, width: Int, height: Int, dark: Boolean, textScale: Float) = onEventThread {
        val workshop = runBlocking { openWorkshop() }
        val settings = workshop.state.settings
        if (textScale > 1f) {
            workshop.handle(
                SettingsEvent.SettingsChanged(settings.copy(language = Language.GERMAN, textScale = textScale)),
            )
        }
        val scene = sceneOf(width, height) { RobotranApp(workshop, dark, embedded = true) }
        try {
            scene.render()
            val bytes = checkNotNull(scene.render(nanoTime = 1_000_000_000).encodeToData(EncodedImageFormat.PNG)).bytes
            file.writeBytes(bytes)
            assertTrue(bytes.size > 1000, "${file.name} is empty")
        } finally {
            scene.close()
            workshop.handle(SettingsEvent.SettingsChanged(settings))
            workshop.close()
        }
    }

    private fun embedded(width: Int, height: Int, check: ComposeUiTest.(Workshop) -> Unit) {
        val workshop = runBlocking { openWorkshop() }
        onScreenOf(workshop, width, height, embedded = true) { check(workshop) }
    }
}
