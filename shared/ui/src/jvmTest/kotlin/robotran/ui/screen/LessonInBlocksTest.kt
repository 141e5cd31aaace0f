package robotran.ui.screen

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import robotran.projects.ProgramView
import robotran.robolang.outline.PhrasePart
import robotran.ui.program.tags.ProgramTags
import robotran.ui.school.tags.LearningTags
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import kotlin.test.Test
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** A lesson over the program in blocks. */
@OptIn(ExperimentalTestApi::class)
class LessonInBlocksTest {
    @Test
    fun `a number pad has room for all its keys, since the lesson yields, and comes back with it`() {
        for ((width, height) in listOf(1180 to 820, 1366 to 768)) {
            onScreen(width, height) { workshop ->
                workshop.handle(LearningEvent.LessonChosen(0))
                workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
                pass(300)
                val line = workshop.state.programs.blocks?.program?.outline?.lines?.first()
                val number = checkNotNull(line).parts.filterIsInstance<PhrasePart.Value>().first()
                workshop.handle(BlockEvent.DialogShown(BlockDialog.Part(number.span)))
                pass(600)
                for (tag in ('0'..'9').map { ProgramTags.digit(it) } + ProgramTags.NUMBER_DONE) {
                    assertWhole(tag, "$width x $height")
                }
                onNodeWithTag(LearningTags.TUTORIAL_TASK, useUnmergedTree = true).assertIsDisplayed()
                onNodeWithTag(LearningTags.FOLD_TUTORIAL).performClick()
                pass(600)
                assertNull(workshop.state.programs.blocks?.sheet)
                onNodeWithTag(LearningTags.TUTORIAL).assertIsDisplayed()
            }
        }
    }

    @Test
    fun `a lesson's program is shown from its beginning, however far down the last one was`() =
        onScreen(1180, 820) { workshop ->
            workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
            workshop.handle(ProgramEvent.ProgramEdited("beep\n".repeat(40)))
            pass(300)
            scroll(ProgramTags.BLOCKS, toEnd = true)
            assertTrue(onAllNodesWithTag(ProgramTags.block("0")).fetchSemanticsNodes().isEmpty())
            workshop.handle(LearningEvent.LessonChosen(8))
            pass(600)
            onNodeWithTag(ProgramTags.block("0")).assertIsDisplayed()
        }
}
