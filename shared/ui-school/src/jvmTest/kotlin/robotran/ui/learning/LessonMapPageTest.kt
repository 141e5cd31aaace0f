package robotran.ui.learning

import androidx.compose.ui.graphics.toPixelMap
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assert
import androidx.compose.ui.test.assertContentDescriptionEquals
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.isFocused
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performScrollToKey
import androidx.compose.ui.test.pressKey
import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.learning.Lessons
import robotran.learning.drawing.readRunDrawing
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.assertWhole
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.scrollAndTouch
import robotran.ui.screen.undrawnTest
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetPictures
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse

@OptIn(ExperimentalTestApi::class)
class LessonMapPageTest {
    private fun onEither(check: ComposeUiTest.(Workshop) -> Unit) {
        onTablet(check)
        onPhone(check)
    }

    private fun ComposeUiTest.assertCard(lesson: String, condition: String) {
        onNodeWithTag(LearningTags.MAP).performScrollToKey(lesson)
        pass(100)
        onNodeWithTag(LearningTags.lesson(lesson)).assert(
            SemanticsMatcher.expectValue(SemanticsProperties.StateDescription, condition),
        )
    }

    private fun Workshop.solveFirst() {
        handle(LearningEvent.TutorialStarted)
        handle(ProgramEvent.ProgramEdited(Lessons.all[0].solution.text))
        handle(RunEvent.RunPressed)
        advance(8000)
    }

    @Test
    fun `the map tells what is done, what is next and what is open`() = onEither { workshop ->
        workshop.solveFirst()
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        pass(100)
        assertCard("first-drive", "done")
        assertCard("pen", "next")
        assertCard("star", "not done yet")
    }

    @Test
    fun `each card says its number, its title and what it teaches`() = onEither { workshop ->
        workshop.solveFirst()
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        pass(100)
        onNodeWithTag(LearningTags.lesson("first-drive"))
            .assertContentDescriptionEquals("Lesson 1, A first drive. You can drive the robot where you want")
        onNodeWithTag(LearningTags.MAP).performScrollToKey("repeat")
        pass(100)
        onNodeWithTag(LearningTags.lesson("repeat"))
            .assertContentDescriptionEquals("Lesson 3, Again and again. Then you can make it repeat")
    }

    @Test
    fun `who has just come is told where to begin, and who has done a lesson, how far it is`() = onTablet { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        pass(100)
        onNodeWithText("Begin with the yellow card, or with any other that you like.").assertIsDisplayed()
        workshop.solveFirst()
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        pass(100)
        onNodeWithText("1 of ${Lessons.all.size} lessons done. The yellow card is next.").assertIsDisplayed()
    }

    @Test
    fun `the page begins where the next lesson is in sight, and what is above it`() = onPhone { workshop ->
        workshop.handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == "line" }))
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        pass(300)
        onNodeWithTag(LearningTags.lesson("line")).assertIsDisplayed()
        onNodeWithTag(LearningTags.lesson("stripes")).assertIsDisplayed()
    }

    @Test
    fun `the next lesson is in sight as a whole, with text of any size and in any language`() {
        for (settings in listOf(
            Settings(textScale = 2f),
            Settings(language = Language.GERMAN, textScale = 2f),
            Settings(),
        )) {
            onEither { workshop ->
                workshop.handle(SettingsEvent.SettingsChanged(settings))
                for (lesson in listOf("flower", "racing-line", "behaviours")) {
                    workshop.handle(LearningEvent.LessonChosen(Lessons.all.indexOfFirst { it.name == lesson }))
                    workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
                    pass(500)
                    assertWhole(LearningTags.lesson(lesson), "$settings")
                    workshop.handle(LearningEvent.PageClosed)
                    pass(100)
                }
            }
        }
    }

    @Test
    fun `a touch on a card opens its lesson`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        pass(100)
        onNodeWithTag(LearningTags.MAP).performScrollToKey("star")
        pass(100)
        onNodeWithTag(LearningTags.lesson("star")).assertIsDisplayed().performClick()
        pass(100)
        onNodeWithTag(LearningTags.MAP_PAGE).assertDoesNotExist()
        assertEquals("star", workshop.state.learning.tutorial?.current?.name)
        assertEquals(Lessons.named("star")?.program?.text, workshop.state.programText)
    }

    @Test
    fun `the Tab key goes from lesson to lesson`() = onTablet { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        pass(300)
        val first = Lessons.strands.first().lessons.map { "lesson-${it.name}" }
        val reached = (1..first.size + 3 + Lessons.strands.size).mapNotNull {
            onRoot().performKeyInput { pressKey(Key.Tab) }
            pass(50)
            onNode(isFocused()).fetchSemanticsNode().config.getOrNull(SemanticsProperties.TestTag)
        }
        assertEquals(first, reached.filter { it in first })
    }

    @Test
    fun `a card has the drawing of the solution until the pupil has one`() = undrawnTest(10, 10) {
        val lesson = Lessons.all.first { it.name == "star" }
        val room = PictureBounds.of(200, 150, density = 1f)
        val pictures = listOf(null, readRunDrawing("robot 200 200 90\nink 0 300 300 200 0 0 200")).map { own ->
            runBlocking { LessonPictures.of(ShownLesson(lesson, own), SheetColours.LIGHT, room) }.toPixelMap().buffer
        }
        val begun = runBlocking {
            SheetPictures().of("star", lesson.world(Language.ENGLISH), SheetColours.LIGHT, room)
        }.toPixelMap().buffer
        assertFalse(pictures[0].contentEquals(begun), "nothing is drawn")
        assertFalse(pictures[0].contentEquals(pictures[1]), "the pupil's drawing is not shown")
    }

    @Test
    fun `a touch on the sign of a strand goes to its lessons, and the keyboard goes on from there`() =
        onEither { workshop ->
            workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
            pass(300)
            for (strand in listOf("java", "sense", "drive")) {
                scrollAndTouch(LearningTags.goTo(strand))
                pass(1_000)
                val first = Lessons.strands.first { it.name == strand }.lessons.first()
                onNodeWithTag(LearningTags.strand(strand)).assertIsDisplayed()
                onNodeWithTag(LearningTags.lesson(first.name)).assertIsDisplayed().assertIsFocused()
            }
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
