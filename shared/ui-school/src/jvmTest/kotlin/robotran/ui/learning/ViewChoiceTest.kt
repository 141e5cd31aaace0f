package robotran.ui.learning

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsNotSelected
import androidx.compose.ui.test.assertIsSelected
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import kotlinx.coroutines.runBlocking
import robotran.projects.ProgramView
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.checkTargets
import robotran.ui.screen.onPhone
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.workshop.Workshop
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.state.LearningPage
import kotlin.test.Test
import kotlin.test.assertEquals

/** Tests the choice between blocks and text on the first page, and that the tutorial speaks of what was chosen. */
@OptIn(ExperimentalTestApi::class)
class ViewChoiceTest {
    private fun onEither(check: ComposeUiTest.(Workshop) -> Unit) {
        onTablet(check)
        onPhone(check)
    }

    private fun ComposeUiTest.touch(tag: String) {
        onNodeWithTag(tag).performClick()
        pass(300)
    }

    @Test
    fun `the first page lets a pupil choose blocks, and text again`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.FIRST_RUN))
        pass(100)
        onNodeWithTag(LearningTags.FIRST_TEXT).assertIsDisplayed().assertIsSelected()
        checkTargets(LearningTags.FIRST_BLOCKS, LearningTags.FIRST_TEXT)
        touch(LearningTags.FIRST_BLOCKS)
        onNodeWithTag(LearningTags.FIRST_BLOCKS).assertIsSelected()
        onNodeWithTag(LearningTags.FIRST_TEXT).assertIsNotSelected()
        assertEquals(ProgramView.BLOCKS, workshop.state.programs.view)
        touch(LearningTags.FIRST_TEXT)
        assertEquals(ProgramView.TEXT, workshop.state.programs.view)
        touch(LearningTags.FIRST_BLOCKS)
        touch(LearningTags.TRY_SQUARE)
        assertEquals(ProgramView.BLOCKS, workshop.state.programs.view)
    }

    @Test
    fun `where there are only fingers, blocks are chosen already`() {
        val platform = MemoryPlatform(isForFingers = true)
        val workshop = runBlocking { openWorkshop(platform = platform, welcoming = true) }
        onScreenOf(workshop, 411, 891) {
            onNodeWithTag(LearningTags.FIRST_BLOCKS).assertIsSelected()
            touch(LearningTags.TRY_TUTORIAL)
            assertEquals(ProgramView.BLOCKS, workshop.state.programs.view)
        }
    }

    @Test
    fun `hints of the tutorial speak of what the pupil sees`() = onEither { workshop ->
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        workshop.handle(LearningEvent.TutorialStarted)
        // A nudge, a part of the solution, and how to write it.
        repeat(3) { workshop.handle(LearningEvent.HintRequested(true)) }
        pass(300)
        onNodeWithTag(LearningTags.HINT).assertTextContains("from the group Drive", substring = true)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.TEXT))
        pass(300)
        onNodeWithTag(LearningTags.HINT).assertTextContains("write one more line", substring = true)
    }
}
