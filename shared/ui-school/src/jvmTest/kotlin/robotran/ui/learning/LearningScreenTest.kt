package robotran.ui.learning

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsNodeInteraction
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onFirst
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.pressKey
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.learning.Lessons
import robotran.learning.WorldGallery
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.state.LearningPage
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class LearningScreenTest {
    private fun onEither(check: ComposeUiTest.(Workshop) -> Unit) {
        onTablet(check)
        onPhone(check)
    }

    @Test
    fun `the first page runs the square at a touch`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.FIRST_RUN))
        pass(100)
        for (tag in listOf(
            "try-square",
            "try-tutorial",
            "try-worlds",
        )) {
            onNodeWithTag(tag).assertIsDisplayed().assertLargeEnough()
        }
        onNodeWithTag("try-square").performClick()
        pass(2000)
        assertTrue(workshop.state.session.ink.lengthCentimetres > 5)
        onNodeWithTag("first-run").assertDoesNotExist()
    }

    @Test
    fun `the first page can be gone through with keys alone, and Escape leaves it`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.FIRST_RUN))
        pass(100)
        goTo("try-tutorial")
        onRoot().performKeyInput { pressKey(Key.Enter) }
        pass(200)
        assertTrue(workshop.state.learning.tutorial?.isLoaded == true)
        workshop.handle(LearningEvent.PageRequested(LearningPage.FIRST_RUN))
        pass(100)
        onRoot().performKeyInput { pressKey(Key.Escape) }
        pass(100)
        assertNull(workshop.state.learning.page)
    }

    @Test
    fun `a step is read, tried, solved and done`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.TUTORIAL))
        pass(100)
        onNodeWithTag("step-title").assertTextContains("A first drive")
        press("try-step", workshop)
        workshop.handle(ProgramEvent.ProgramEdited(Lessons.all[0].solution.text))
        unfold(workshop)
        press("run-step", workshop)
        pass(4500)
        assertTrue(workshop.state.learning.isStepDone)
        unfold(workshop)
        onNodeWithTag("task-status").assertTextContains("Your task: done")
        onNodeWithTag("next-step").assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag("step-title").assertTextContains("A line on the paper")
    }

    @Test
    fun `hints come one after the other and go, and the solution can be shown`() = onEither { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        for (text in Lessons.all[0].text(Language.ENGLISH).run { listOf(nudge, part, solution) }) {
            press("hint-wanted", workshop)
            onNodeWithTag("hint").assertExists()
            assertTrue(workshop.state.learning.tutorial?.hints?.last()?.text == text)
        }
        press("hint-wanted", workshop)
        onNodeWithTag("hint").assertDoesNotExist()
        press("solution-wanted", workshop)
        assertTrue(workshop.state.running)
        unfold(workshop)
        assertEquals(Lessons.all[0].solution.text, workshop.state.programText)
        onNodeWithTag("solution-note").assertExists()
        press("solution-wanted", workshop)
        assertEquals(Lessons.all[0].program.text, workshop.state.programText)
    }

    @Test
    fun `on a phone a hint is one touch away after a try that failed`() = onPhone { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(ProgramEvent.ProgramEdited("forward 30\nturn right 90\nforward 25\n"))
        pass(100)
        onNodeWithTag("run").performClick()
        pass(5000)
        onNodeWithTag("folded-hint").assertIsDisplayed().performClick()
        pass(500)
        onNodeWithTag("hint").assertIsDisplayed()
    }

    @Test
    fun `any step can be chosen from the list`() = onEither { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        onNodeWithTag("tutorial-steps").assertLargeEnough().performClick()
        pass(300)
        onNodeWithTag("tutorial-step-6").performClick()
        pass(300)
        onNodeWithTag("step-title").assertTextContains("A star")
    }

    @Test
    fun `the tutorial folds to one line that tells the step`() = onEither { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        onNodeWithTag("fold-tutorial").assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag("tutorial").assertDoesNotExist()
        onNodeWithTag(
            "tutorial-steps",
        ).assertIsDisplayed().assertTextContains("Drive and draw: 1 of 10 · A first drive")
        onNodeWithTag("fold-tutorial").performClick()
        pass(100)
        onNodeWithTag("tutorial").assertIsDisplayed()
    }

    @Test
    fun `on a phone a touch on a pane or on Run folds the tutorial`() = onPhone { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        onNodeWithTag("tab-world").performClick()
        pass(100)
        assertTrue(workshop.state.learning.tutorial?.isFolded == true)
        onNodeWithTag("world").assertIsDisplayed()
    }

    @Test
    fun `on a tablet program, world and tutorial are seen at once`() = onTablet { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        for (tag in listOf(
            "tutorial",
            "program",
            "world",
            "lcd",
            "brick-run",
            "run",
        )) {
            onNodeWithTag(tag).assertIsDisplayed()
        }
    }

    @Test
    fun `one touch leads back to the pupil's own work`() = onEither { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited("forward 3\n"))
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        press("leave-tutorial", workshop)
        assertEquals("forward 3\n", workshop.state.programText)
        onNodeWithTag("tutorial").assertDoesNotExist()
    }

    @Test
    fun `a world is found by typing and opened by a touch`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        pass(200)
        onNodeWithTag("world-plain").assertIsDisplayed().assertLargeEnough()
        onNodeWithTag("world-search").performTextInput("slalom")
        pass(100)
        onNodeWithTag("world-plain").assertDoesNotExist()
        onNodeWithTag("world-slalom").performClick()
        pass(200)
        assertEquals("Slalom", workshop.state.world.title)
        onNodeWithTag("worlds-page").assertDoesNotExist()
    }

    @Test
    fun `worlds are shown by the brick of their robot, and found by its name`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        pass(200)
        onNodeWithTag("worlds-nxt").assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag("world-plain").assertDoesNotExist()
        val nxt = WorldGallery.worlds.first { it.plainWorld.robots.first().description.brick == BrickKind.NXT }
        onNodeWithTag("world-${nxt.name}").assertExists()
        onNodeWithTag("world-search").performTextInput("rcx")
        pass(100)
        onNodeWithTag("worlds-none").assertIsDisplayed()
        onNodeWithTag("worlds-all").performClick()
        pass(100)
        onNodeWithTag("worlds-none").assertDoesNotExist()
        onNodeWithTag("world-${nxt.name}").assertDoesNotExist()
    }

    @Test
    fun `where no world is found it is said what to do, and a touch clears the search`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        workshop.handle(LearningEvent.WorldSearchChanged("submarine"))
        pass(200)
        onNodeWithTag("worlds-none").assertIsDisplayed()
        onNodeWithTag("world-search-clear").assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag("world-search").assertIsFocused()
        onNodeWithTag("world-plain").assertIsDisplayed()
    }

    @Test
    fun `a world can be chosen with keys alone`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        pass(200)
        goTo("world-square")
        onRoot().performKeyInput { pressKey(Key.Enter) }
        pass(200)
        assertEquals("A square", workshop.state.world.title)
    }

    @Test
    fun `help explains a word and lets its example be tried`() = onEither { workshop ->
        workshop.handle(LearningEvent.HelpRequested("repeat 4 times", 2))
        pass(200)
        onNodeWithTag("help-title").assertTextContains("repeat")
        onNodeWithTag("help-sentence").assertTextContains("again and again", substring = true)
        press("help-try", workshop)
        assertEquals("try.robo", workshop.state.programName)
        onNodeWithTag("help").assertDoesNotExist()
    }

    @Test
    fun `a word without help leads to the list of all words, in either language`() = onEither { workshop ->
        workshop.handle(LearningEvent.HelpRequested("side", 2))
        pass(200)
        onNodeWithTag("help-none").assertTextContains("side", substring = true)
        onNodeWithTag("word-forward").assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag("help-title").assertTextContains("forward")
        press("help-all", workshop)
        onNodeWithTag("help-java").performClick()
        pass(100)
        onNodeWithTag("word-Motor").assertIsDisplayed()
        onNodeWithTag("help-close").assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag("help").assertDoesNotExist()
    }

    @Test
    fun `Escape closes the help`() = onEither { workshop ->
        workshop.handle(LearningEvent.HelpRequested("forward", 2))
        pass(200)
        onRoot().performKeyInput { pressKey(Key.Escape) }
        pass(100)
        assertNull(workshop.state.learning.page)
        assertFalse(workshop.state.running)
    }

    /** Clicks an element that may need scrolling. */
    private fun ComposeUiTest.press(tag: String, workshop: Workshop) {
        unfold(workshop)
        onNodeWithTag(tag).click()
        pass(200)
    }

    /** Clicks like a screen reader, regardless of the scroll position. */
    private fun SemanticsNodeInteraction.click() {
        assertLargeEnough()
        fetchSemanticsNode().config[SemanticsActions.OnClick].action?.invoke()
    }

    private fun ComposeUiTest.unfold(workshop: Workshop) {
        if (workshop.state.learning.tutorial?.isFolded == true) workshop.handle(LearningEvent.TutorialFolded(false))
        pass(100)
    }

    private fun SemanticsNodeInteraction.assertLargeEnough() = apply {
        val size = fetchSemanticsNode().size
        assertTrue(size.width >= 48 && size.height >= 48, "only $size")
    }

    /** Presses Tab until the node with [tag] has the focus. */
    private fun ComposeUiTest.goTo(tag: String) {
        repeat(STEPS) {
            val focused = onAllNodesWithTag(
                tag,
            ).onFirst().fetchSemanticsNode().config.getOrNull(SemanticsProperties.Focused)
            if (focused == true) return
            onRoot().performKeyInput { pressKey(Key.Tab) }
            pass(50)
        }
        error("The Tab key does not reach $tag")
    }

    private companion object {
        /** More than the number of focusable elements. */
        const val STEPS = 40
    }
}
