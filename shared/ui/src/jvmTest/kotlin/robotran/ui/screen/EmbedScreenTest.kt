package robotran.ui.screen

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsEnabled
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.DocumentTags
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
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
            WorldTags.WORLD,
            RunTags.BRICK,
            RunTags.RUN,
            RunTags.STOP,
            RunTags.START_OVER,
            RunTags.STATUS,
        )) {
            onNodeWithTag(tag).assertIsDisplayed()
        }
        for (tag in listOf(
            ProgramTags.PROGRAM,
            ScreenTags.MENU,
            DocumentTags.WORK_MENU,
            ScreenTags.LEARN,
            ScreenTags.EDIT_WORLD,
        )) {
            onNodeWithTag(tag).assertDoesNotExist()
        }
    }

    @Test
    fun `it runs, stops and goes back to the start`() = embedded(800, 500) { workshop ->
        onNodeWithTag(RunTags.START_OVER).assertIsNotEnabled()
        onNodeWithTag(RunTags.RUN).performClick()
        pass(500)
        assertTrue(workshop.state.running)
        onNodeWithTag(RunTags.STOP).assertIsEnabled().performClick()
        pass(300)
        assertFalse(workshop.state.running)
        assertTrue(workshop.state.session.ink.lengthCentimetres > 0)
        onNodeWithTag(RunTags.START_OVER).performClick()
        pass(300)
        assertTrue(workshop.state.session.ink.lengthCentimetres == 0.0)
    }

    @Test
    fun `where there is little room the brick shrinks to its display and Run`() = embedded(320, 420) {
        onNodeWithTag(RunTags.BRICK).assertDoesNotExist()
        for (tag in listOf(
            WorldTags.WORLD,
            RunTags.LCD,
            RunTags.button(BrickButton.RUN),
            RunTags.RUN,
            RunTags.STOP,
            RunTags.START_OVER,
        )) {
            onNodeWithTag(tag).assertIsDisplayed()
        }
    }

    @Test
    fun `a link that cannot be used is told in a sentence instead`() = embedded(800, 500) { workshop ->
        workshop.handle(DocumentEvent.LinkOpened("#p=aXXXX"))
        pass(200)
        onNodeWithTag(DocumentTags.DOCUMENT_TROUBLE).assertIsDisplayed()
        onNodeWithTag(RunTags.RUN).assertDoesNotExist()
    }

    private fun embedded(width: Int, height: Int, check: ComposeUiTest.(Workshop) -> Unit) {
        val workshop = runBlocking { openWorkshop() }
        onScreenOf(workshop, width, height, embedded = true) { check(workshop) }
    }
}
