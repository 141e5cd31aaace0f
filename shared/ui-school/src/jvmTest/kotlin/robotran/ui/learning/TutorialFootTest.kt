package robotran.ui.learning

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import robotran.language.Language
import robotran.learning.Lessons
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.assertUnmoved
import robotran.ui.screen.assertWhole
import robotran.ui.screen.isThere
import robotran.ui.screen.onScreen
import robotran.ui.screen.pass
import robotran.ui.screen.placesByTag
import robotran.ui.screen.saysThereIsMore
import robotran.ui.screen.scrollTo
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class TutorialFootTest {
    @Test
    fun `the text shows that there is more of it`() {
        for ((width, height) in SIZES) {
            onStep(width, height, Settings(textScale = 2f)) {
                if (!isThere(LearningTags.EXPLANATION_TEXT)) {
                    scrollTo(LearningTags.EXPLANATION)
                    press(LearningTags.EXPLANATION)
                }
                val parts = listOf(LearningTags.TUTORIAL_TEXT, LearningTags.TASK_AND_HELP).filter { isThere(it) }
                assertTrue(parts.any { saysThereIsMore(it) }, "$width x $height")
            }
        }
    }

    @Test
    fun `back, next and a menu with the seldom actions are in one row`() = onEachSize { workshop, described ->
        val row = placesByTag()
        val tags = listOf(LearningTags.PREVIOUS_STEP, LearningTags.STEP_MORE, LearningTags.NEXT_STEP)
        assertEquals(1, tags.map { row.getValue(it).center.y }.toSet().size, described)
        workshop.handle(ProgramEvent.ProgramEdited("beep"))
        press(LearningTags.STEP_MORE)
        press(LearningTags.BEGIN_AGAIN)
        assertEquals(Lessons.all[0].program.text, workshop.state.programText)
        press(LearningTags.STEP_MORE)
        press(LearningTags.LEAVE_TUTORIAL)
        assertNull(workshop.state.learning.tutorial)
    }

    @Test
    fun `the task is in sight at once, and there is one Run`() = onEachSize { _, described ->
        assertWhole(LearningTags.TASK_STATUS, described)
        val task = placesByTag().getValue(LearningTags.TASK)
        assertTrue(task.height > 40, "$described: $task")
        onNodeWithTag(RunTags.RUN).assertIsDisplayed()
        onNodeWithTag("run-step").assertDoesNotExist()
    }

    @Test
    fun `how it works unfolds below the task`() = onStep(1366, 768) { workshop ->
        val text = workshop.state.learning.tutorial?.current?.text(Language.ENGLISH)?.paragraphs.orEmpty()
        onNodeWithText(text.first().substringBefore('`'), substring = true).assertDoesNotExist()
        scrollTo(LearningTags.EXPLANATION)
        press(LearningTags.EXPLANATION)
        onNodeWithText(text.first().substringBefore('`'), substring = true).assertExists()
    }

    @Test
    fun `a hint comes under its button, which stays for whoever touches twice where there is room`() =
        onStep(1366, 1200) { workshop ->
            val before = placesByTag()
            press(LearningTags.HINT_WANTED)
            assertTrue(workshop.state.learning.tutorial?.hints?.isNotEmpty() == true)
            assertWhole(LearningTags.HINT, "the hint")
            assertUnmoved(
                before,
                listOf(LearningTags.HINT_WANTED, LearningTags.SOLUTION_WANTED, LearningTags.NEXT_STEP),
                "with the hint",
            )
        }

    @Test
    fun `with each hint, the button for the next one stays in sight`() {
        for ((width, height) in listOf(412 to 915, 1180 to 820, 1366 to 768)) {
            onStep(width, height) {
                for (number in 1..3) {
                    scrollTo(LearningTags.HINT_WANTED)
                    press(LearningTags.HINT_WANTED)
                    pass(1_000)
                    for (tag in listOf(
                        LearningTags.HINT,
                        LearningTags.HINT_WANTED,
                    )) {
                        assertWhole(tag, "$width x $height, hint $number")
                    }
                }
            }
        }
    }

    @Test
    fun `over another world a folded tutorial is a way back to its step, and can be put away`() {
        for ((width, height) in SIZES) {
            onStep(width, height) { workshop ->
                val described = "$width x $height"
                workshop.handle(ProgramEvent.ProgramEdited("forward 11\n"))
                workshop.handle(LearningEvent.TutorialClosed)
                workshop.handle(LearningEvent.WorldChosen("maze"))
                workshop.handle(LearningEvent.PageRequested(LearningPage.TUTORIAL))
                workshop.handle(LearningEvent.TutorialFolded(true))
                pass(500)
                assertFalse(isThere(LearningTags.STEP_DOTS), "$described: the steps of another world are told")
                press(LearningTags.TUTORIAL_RETURN)
                assertTrue(workshop.state.learning.tutorial.let { it?.isLoaded == true && !it.isFolded }, described)
                assertEquals("forward 11\n", workshop.state.programText, described)
                workshop.handle(LearningEvent.TutorialClosed)
                workshop.handle(LearningEvent.PageRequested(LearningPage.TUTORIAL))
                workshop.handle(LearningEvent.TutorialFolded(true))
                pass(500)
                press(LearningTags.LEAVE_TUTORIAL)
                assertNull(workshop.state.learning.tutorial, described)
                assertFalse(isThere(LearningTags.TUTORIAL_RETURN), described)
            }
        }
    }

    private fun onEachSize(check: ComposeUiTest.(Workshop, described: String) -> Unit) {
        for ((width, height) in SIZES) onStep(width, height) { check(it, "$width x $height") }
    }

    private fun onStep(
        width: Int,
        height: Int,
        settings: Settings = Settings(),
        check: ComposeUiTest.(Workshop) -> Unit,
    ) = onScreen(width, height) { workshop ->
        workshop.handle(SettingsEvent.SettingsChanged(settings.copy(lessMotion = true)))
        workshop.handle(LearningEvent.TutorialStarted)
        pass(500)
        check(workshop)
    }

    private fun ComposeUiTest.press(tag: String) {
        onNodeWithTag(tag).performClick()
        pass(600)
    }

    private companion object {
        val SIZES = listOf(412 to 915, 820 to 1180, 1024 to 768, 1280 to 800, 1366 to 768)
    }
}
