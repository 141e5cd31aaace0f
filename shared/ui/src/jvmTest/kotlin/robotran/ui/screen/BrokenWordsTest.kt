package robotran.ui.screen

import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.text.TextLayoutResult
import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.learning.Lessons
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.tags.ScreenTags
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals

/** On a phone, above all with the largest text, no word is broken that would fit into the width of its place. */
@OptIn(ExperimentalTestApi::class)
class BrokenWordsTest {
    @Test
    fun `in a lesson`() = inEachLanguage { workshop ->
        for (index in Lessons.all.indices step 9) {
            workshop.handle(LearningEvent.StepChosen(index))
            pass(300)
            assertNoBrokenWords("lesson $index")
        }
    }

    @Test
    fun `beside the sheet, after a try that failed`() = inEachLanguage { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited("forward 10\nturn right 90\nforward 25\n"))
        workshop.handle(LearningEvent.TutorialFolded(true))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(20_000)
        pass(600)
        assertNoBrokenWords("the verdict")
    }

    @Test
    fun `beside the sheet of a small phone, with the lesson and its hint above`() {
        for ((width, height) in listOf(360 to 780, 390 to 844)) {
            inEachLanguage(width, height) { workshop ->
                workshop.handle(ProgramEvent.ProgramEdited("forward 10\n"))
                workshop.handle(LearningEvent.TutorialFolded(true))
                workshop.handle(RunEvent.RunPressed)
                workshop.advance(20_000)
                pass(600)
                onNodeWithTag(LearningTags.FOLDED_HINT).assertIsDisplayed()
                onNodeWithTag(ScreenTags.MISSING_CARD).assertIsDisplayed()
                assertNoBrokenWords("the verdict at $width")
            }
        }
    }

    @Test
    fun `beside the sheet of a phone held across, in the card of a task, at the normal size of text`() {
        for (world in listOf("block-push", "obstacle-course", "line-gaps")) {
            onScreen(891, 411) { workshop ->
                workshop.handle(LearningEvent.WorldChosen(world))
                workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
                pass(300)
                onNodeWithTag(AssignmentTags.TASK_TITLE).assertIsDisplayed()
                assertNoBrokenWords("the task of $world")
            }
        }
    }

    private fun inEachLanguage(width: Int = WIDTH, height: Int = HEIGHT, check: ComposeUiTest.(Workshop) -> Unit) {
        for (language in Language.entries) {
            val workshop = runBlocking { openWorkshop() }
            val settings = Settings(textScale = 2f, lessMotion = true, language = language)
            workshop.handle(SettingsEvent.SettingsChanged(settings))
            workshop.handle(LearningEvent.TutorialStarted)
            onScreenOf(workshop, width, height) {
                pass(300)
                check(workshop)
            }
        }
    }

    private fun ComposeUiTest.assertNoBrokenWords(described: String) {
        val hasText = SemanticsMatcher.keyIsDefined(SemanticsActions.GetTextLayoutResult)
        val broken = onAllNodes(hasText, useUnmergedTree = true).fetchSemanticsNodes().flatMap { node ->
            val layouts = mutableListOf<TextLayoutResult>()
            node.config.getOrNull(SemanticsActions.GetTextLayoutResult)?.action?.invoke(layouts)
            layouts.flatMap { it.brokenWords() }
        }
        assertEquals(emptyList(), broken, described)
    }

    private fun TextLayoutResult.brokenWords(): List<String> {
        val text = layoutInput.text.text
        return (0..<lineCount - 1).map { getLineEnd(it) }
            .filter { it in 1..<text.length && text[it - 1].isLetterOrDigit() && text[it].isLetterOrDigit() }
            .map { end ->
                val first = text.substring(0, end).takeLastWhile { it.isLetterOrDigit() }
                first + "/" + text.substring(end).takeWhile { it.isLetterOrDigit() }
            }
            .filter { it.length < LONGEST }
    }

    private companion object {
        const val WIDTH = 412
        const val HEIGHT = 915

        /** With the stroke between its parts; longer words may not fit into the width. */
        const val LONGEST = 19
    }
}
