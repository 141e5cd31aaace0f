package robotran.ui.learning

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assert
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.isFocused
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.pressKey
import robotran.learning.Lessons
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.state.LearningPage
import kotlin.test.Test
import kotlin.test.assertEquals

@OptIn(ExperimentalTestApi::class)
class LessonMapPageTest {
    private fun onEither(check: ComposeUiTest.(Workshop) -> Unit) {
        onTablet(check)
        onPhone(check)
    }

    private fun ComposeUiTest.assertStation(lesson: String, condition: String) {
        onNodeWithTag(LearningTags.lesson(lesson)).assert(
            SemanticsMatcher.expectValue(SemanticsProperties.StateDescription, condition),
        )
    }

    @Test
    fun `the map tells what is done, what is next and what is open`() = onEither { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(ProgramEvent.ProgramEdited(Lessons.all[0].solution.text))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(8000)
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        pass(100)
        assertStation("first-drive", "done")
        assertStation("pen", "next")
        assertStation("star", "not done yet")
    }

    @Test
    fun `a touch on a station opens its lesson`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        pass(100)
        onNodeWithTag(LearningTags.lesson("star")).assertIsDisplayed().performClick()
        pass(100)
        onNodeWithTag(LearningTags.MAP_PAGE).assertDoesNotExist()
        assertEquals("star", workshop.state.learning.tutorial?.current?.name)
        assertEquals(Lessons.named("star")?.program?.text, workshop.state.programText)
    }

    @Test
    fun `the Tab key goes from lesson to lesson, also where the path goes back`() = onTablet { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        pass(300)
        val first = Lessons.strands.first().lessons.map { "lesson-${it.name}" }
        val reached = (1..first.size + 3).mapNotNull {
            onRoot().performKeyInput { pressKey(Key.Tab) }
            pass(50)
            onNode(isFocused()).fetchSemanticsNode().config.getOrNull(SemanticsProperties.TestTag)
        }
        assertEquals(first, reached.filter { it in first })
    }

    @Test
    fun `from a lesson the map is one touch away`() = onTablet { workshop ->
        workshop.handle(LearningEvent.TutorialStarted)
        pass(100)
        onNodeWithTag(LearningTags.LESSON_MAP).performClick()
        pass(100)
        onNodeWithTag(LearningTags.MAP_PAGE).assertIsDisplayed()
    }
}
