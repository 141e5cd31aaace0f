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
import androidx.compose.ui.test.assertIsNotSelected
import androidx.compose.ui.test.assertIsSelected
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onFirst
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.pressKey
import robotran.brick.controls.BrickButton
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.Lessons
import robotran.learning.WorldGallery
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.onPhone
import robotran.ui.screen.onScreen
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.pixelsOf
import robotran.ui.screen.scrollTo
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.world.tags.WorldTags
import robotran.uikit.RobotranColours
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Pane
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
            LearningTags.TRY_SQUARE,
            LearningTags.TRY_TUTORIAL,
            LearningTags.TRY_WORLDS,
        )) {
            onNodeWithTag(tag).assertIsDisplayed().assertLargeEnough()
        }
        onNodeWithTag(LearningTags.TRY_SQUARE).performClick()
        pass(2000)
        assertTrue(workshop.state.session.ink.lengthCentimetres > 5)
        onNodeWithTag(LearningTags.FIRST_RUN).assertDoesNotExist()
    }

    @Test
    fun `the first page can be gone through with keys alone, and Escape leaves it`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.FIRST_RUN))
        pass(100)
        goTo(LearningTags.TRY_TUTORIAL)
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
        onNodeWithTag(LearningTags.STEP_TITLE).assertTextContains("A first drive")
        press(LearningTags.TRY_STEP, workshop)
        workshop.handle(ProgramEvent.ProgramEdited(Lessons.all[0].solution.text))
        unfold(workshop)
        onNodeWithTag(RunTags.RUN).performClick()
        pass(4500)
        assertTrue(workshop.state.learning.isStepDone)
        unfold(workshop)
        onNodeWithTag(LearningTags.TASK_STATUS).assertTextContains("Your task: done")
        onNodeWithTag(LearningTags.NEXT_STEP).assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag(LearningTags.STEP_TITLE).assertTextContains("A line on the paper")
    }

    @Test
    fun `a line of the task stays when it has scrolled away for a hint`() = onScreen(1366, 768) { workshop ->
        workshop.handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == "java-counting" }))
        pass(300)
        onNodeWithTag(LearningTags.TASK_LINE).assertDoesNotExist()
        repeat(3) {
            workshop.handle(LearningEvent.HintRequested(true))
            pass(600)
            onNodeWithTag(LearningTags.HINT).assertIsDisplayed()
        }
        scrollTo(LearningTags.EXPLANATION)
        pass(300)
        onNodeWithTag(LearningTags.TASK_LINE).assertIsDisplayed()
        scrollTo(LearningTags.TASK_STATUS)
        pass(300)
        onNodeWithTag(LearningTags.TASK_LINE).assertDoesNotExist()
    }

    @Test
    fun `on a phone a lesson that has been opened leads to its program, and no tab claims to be shown`() =
        onPhone { workshop ->
            workshop.handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == "star" }))
            pass(300)
            for (pane in Pane.entries) onNodeWithTag(ScreenTags.tab(pane)).assertIsNotSelected()
            onNodeWithTag(LearningTags.TASK).assertIsDisplayed()
            onNodeWithTag(LearningTags.TO_PROGRAM).assertLargeEnough().performClick()
            pass(300)
            onNodeWithTag(ScreenTags.tab(Pane.PROGRAM)).assertIsSelected()
            onNodeWithTag(LearningTags.TUTORIAL_TASK, useUnmergedTree = true).assertIsDisplayed()
            onNodeWithTag(LearningTags.FOLD_TUTORIAL).performClick()
            pass(300)
            onNodeWithTag(LearningTags.TASK).assertIsDisplayed()
            onNodeWithTag(ScreenTags.tab(Pane.WORLD)).performClick()
            pass(300)
            onNodeWithTag(WorldTags.WORLD).assertIsDisplayed()
        }

    @Test
    fun `only one button is yellow while a lesson that is not begun offers to try it`() = onTablet { workshop ->
        val isYellow = { tag: String -> pixelsOf(tag).run { this[width / 8, height / 2] } == RobotranColours.YELLOW }
        assertTrue(isYellow(RunTags.RUN))
        workshop.handle(LearningEvent.PageRequested(LearningPage.TUTORIAL))
        pass(300)
        assertEquals(listOf(true, false), listOf(LearningTags.TRY_STEP, RunTags.RUN).map(isYellow))
        onNodeWithTag(LearningTags.TRY_STEP).performClick()
        pass(300)
        assertTrue(isYellow(RunTags.RUN))
    }

    @Test
    fun `hints come one after the other and go, and the solution can be shown`() = onEither { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        for (text in Lessons.all[0].text(Language.ENGLISH).run { listOf(nudge, part, solution) }) {
            press(LearningTags.HINT_WANTED, workshop)
            onNodeWithTag(LearningTags.HINT).assertExists()
            assertTrue(workshop.state.learning.tutorial?.hints?.last()?.text == text)
        }
        press(LearningTags.HINT_WANTED, workshop)
        onNodeWithTag(LearningTags.HINT).assertDoesNotExist()
        press(LearningTags.SOLUTION_WANTED, workshop)
        assertTrue(workshop.state.running)
        unfold(workshop)
        assertEquals(Lessons.all[0].solution.text, workshop.state.programText)
        onNodeWithTag(LearningTags.SOLUTION_NOTE).assertExists()
        press(LearningTags.SOLUTION_WANTED, workshop)
        assertEquals(Lessons.all[0].program.text, workshop.state.programText)
    }

    @Test
    fun `on a phone a hint is one touch away after a try that failed`() = onPhone { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(ProgramEvent.ProgramEdited("forward 30\nturn right 90\nforward 25\n"))
        pass(100)
        onNodeWithTag(RunTags.RUN).performClick()
        pass(5000)
        onNodeWithTag(LearningTags.FOLDED_HINT).assertIsDisplayed().performClick()
        pass(500)
        onNodeWithTag(LearningTags.HINT).assertIsDisplayed()
    }

    @Test
    fun `any step can be chosen from the list`() = onEither { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        onNodeWithTag(LearningTags.TUTORIAL_STEPS).assertLargeEnough().performClick()
        pass(300)
        onNodeWithTag(LearningTags.tutorialStep(6)).performClick()
        pass(300)
        onNodeWithTag(LearningTags.STEP_TITLE).assertTextContains("A star")
    }

    @Test
    fun `the tutorial folds to one line that tells the step`() = onEither { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        onNodeWithTag(LearningTags.FOLD_TUTORIAL).assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag(LearningTags.TUTORIAL).assertDoesNotExist()
        onNodeWithTag(LearningTags.TUTORIAL_STEPS)
            .assertIsDisplayed().assertTextContains("A first drive · Drive and draw: 1 of 10")
        onNodeWithTag(LearningTags.FOLD_TUTORIAL).performClick()
        pass(100)
        onNodeWithTag(LearningTags.TUTORIAL).assertIsDisplayed()
    }

    @Test
    fun `on a phone a touch on a pane or on Run folds the tutorial`() = onPhone { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        onNodeWithTag(ScreenTags.tab(Pane.WORLD)).performClick()
        pass(100)
        assertTrue(workshop.state.learning.tutorial?.isFolded == true)
        onNodeWithTag(WorldTags.WORLD).assertIsDisplayed()
    }

    @Test
    fun `on a tablet program, world and tutorial are seen at once`() = onTablet { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        for (tag in listOf(
            LearningTags.TUTORIAL,
            ProgramTags.PROGRAM,
            WorldTags.WORLD,
            RunTags.LCD,
            RunTags.button(BrickButton.RUN),
            RunTags.RUN,
        )) {
            onNodeWithTag(tag).assertIsDisplayed()
        }
    }

    @Test
    fun `two touches lead back to the pupil's own work`() = onEither { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited("forward 3\n"))
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        press(LearningTags.STEP_MORE, workshop)
        press(LearningTags.LEAVE_TUTORIAL, workshop)
        assertEquals("forward 3\n", workshop.state.programText)
        onNodeWithTag(LearningTags.TUTORIAL).assertDoesNotExist()
    }

    @Test
    fun `a world is found by typing and opened by a touch`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        pass(200)
        onNodeWithTag(LearningTags.world("plain")).assertIsDisplayed().assertLargeEnough()
        onNodeWithTag(LearningTags.WORLD_SEARCH).performTextInput("slalom")
        pass(100)
        onNodeWithTag(LearningTags.world("plain")).assertDoesNotExist()
        onNodeWithTag(LearningTags.world("slalom")).performClick()
        pass(200)
        assertEquals("Slalom", workshop.state.world.title)
        onNodeWithTag(LearningTags.WORLDS_PAGE).assertDoesNotExist()
    }

    @Test
    fun `worlds are shown by the brick of their robot, and found by its name`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        pass(200)
        onNodeWithTag(LearningTags.worlds(BrickKind.NXT)).assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag(LearningTags.world("plain")).assertDoesNotExist()
        val nxt = WorldGallery.worlds.first { it.plainWorld.robots.first().description.brick == BrickKind.NXT }
        onNodeWithTag(LearningTags.world(nxt.name)).assertExists()
        onNodeWithTag(LearningTags.WORLD_SEARCH).performTextInput("rcx")
        pass(100)
        onNodeWithTag(LearningTags.WORLDS_NONE).assertIsDisplayed()
        onNodeWithTag(LearningTags.worlds(null)).performClick()
        pass(100)
        onNodeWithTag(LearningTags.WORLDS_NONE).assertDoesNotExist()
        onNodeWithTag(LearningTags.world(nxt.name)).assertDoesNotExist()
    }

    @Test
    fun `where no world is found it is said what to do, and a touch clears the search`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        workshop.handle(LearningEvent.WorldSearchChanged("submarine"))
        pass(200)
        onNodeWithTag(LearningTags.WORLDS_NONE).assertIsDisplayed()
        onNodeWithTag(LearningTags.WORLD_SEARCH_CLEAR).assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag(LearningTags.WORLD_SEARCH).assertIsFocused()
        onNodeWithTag(LearningTags.world("plain")).assertIsDisplayed()
    }

    @Test
    fun `a world can be chosen with keys alone`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        pass(200)
        goTo(LearningTags.world("square"))
        onRoot().performKeyInput { pressKey(Key.Enter) }
        pass(200)
        assertEquals("A square", workshop.state.world.title)
    }

    @Test
    fun `help explains a word and lets its example be tried`() = onEither { workshop ->
        workshop.handle(LearningEvent.HelpRequested("repeat 4 times", 2))
        pass(200)
        onNodeWithTag(LearningTags.HELP_TITLE).assertTextContains("repeat")
        onNodeWithTag(LearningTags.HELP_SENTENCE).assertTextContains("again and again", substring = true)
        press(LearningTags.HELP_TRY, workshop)
        assertEquals("try.robo", workshop.state.programName)
        onNodeWithTag(LearningTags.HELP).assertDoesNotExist()
    }

    @Test
    fun `a word without help leads to the list of all words, in either language`() = onEither { workshop ->
        workshop.handle(LearningEvent.HelpRequested("side", 2))
        pass(200)
        onNodeWithTag(LearningTags.HELP_NONE).assertTextContains("side", substring = true)
        onNodeWithTag(LearningTags.word("forward")).assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag(LearningTags.HELP_TITLE).assertTextContains("forward")
        press(LearningTags.HELP_ALL, workshop)
        onNodeWithTag(LearningTags.help(ProgramLanguage.JAVA)).performClick()
        pass(100)
        onNodeWithTag(LearningTags.word("Motor")).assertIsDisplayed()
        onNodeWithTag(LearningTags.HELP_CLOSE).assertLargeEnough().performClick()
        pass(100)
        onNodeWithTag(LearningTags.HELP).assertDoesNotExist()
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
