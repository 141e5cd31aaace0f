package robotran.ui.screen

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsEnabled
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import kotlinx.coroutines.runBlocking
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.openWorkshop
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

    private fun embedded(width: Int, height: Int, check: ComposeUiTest.(Workshop) -> Unit) {
        val workshop = runBlocking { openWorkshop() }
        onScreenOf(workshop, width, height, embedded = true) { check(workshop) }
    }
}
