package robotran.ui.learning

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.compose.ui.test.performScrollToKey
import robotran.assignments.course.OwnCourses
import robotran.learning.Lessons
import robotran.learning.WorldGallery
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.workshop.Workshop
import robotran.workshop.event.LearningEvent
import robotran.workshop.state.CoursePage
import robotran.workshop.state.LearningPage
import kotlin.test.Test
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull

@OptIn(ExperimentalTestApi::class)
class TeachersPageTest {
    private fun onEither(check: ComposeUiTest.(Workshop) -> Unit) {
        onTablet(check)
        onPhone(check)
    }

    private fun ComposeUiTest.press(tag: String) {
        onNodeWithTag(tag).performScrollTo().performClick()
        pass(300)
    }

    private fun Workshop.openTeachers() = handle(LearningEvent.PageRequested(LearningPage.TEACHERS))

    @Test
    fun `the welcome page leads to what is for teachers`() = onEither { workshop ->
        workshop.handle(LearningEvent.PageRequested(LearningPage.FIRST_RUN))
        pass(300)
        press(LearningTags.TRY_TEACHERS)
        onNodeWithTag(LearningTags.TEACHERS_PAGE).assertIsDisplayed()
    }

    @Test
    fun `from there assignments are made, and courses made and looked at`() {
        for ((tag, isThere) in listOf<Pair<String, (Workshop) -> Unit>>(
            LearningTags.TEACHERS_MAKE to { assertNotNull(it.state.making) },
            LearningTags.TEACHERS_COURSES to { assertIs<CoursePage.MyCourses>(it.state.course.page) },
            LearningTags.TEACHERS_COURSE_MAKE to { assertIs<CoursePage.Making>(it.state.course.page) },
        )) {
            onPhone { workshop ->
                workshop.openTeachers()
                pass(300)
                press(tag)
                isThere(workshop)
                assertNull(workshop.state.learning.page, "it would lie below $tag")
            }
        }
    }

    @Test
    fun `hand-ins are looked at in a world with goals, and in any other a file is opened first`() =
        onTablet { workshop ->
            workshop.openTeachers()
            pass(300)
            onNodeWithTag(LearningTags.TEACHERS_HAND_INS).assertDoesNotExist()
            onNodeWithTag(LearningTags.TEACHERS_OPEN).assertIsDisplayed()
            workshop.handle(LearningEvent.WorldChosen("maze"))
            pass(300)
            workshop.openTeachers()
            pass(300)
            onNodeWithTag(LearningTags.TEACHERS_OPEN).assertDoesNotExist()
            press(LearningTags.TEACHERS_HAND_INS)
            assertNotNull(workshop.state.handIns)
        }

    @Test
    fun `nothing for teachers stands among lessons, worlds and what pupils do with their work`() =
        onTablet { workshop ->
            for ((page, cards, last) in listOf(
                Triple(LearningPage.MAP, LearningTags.MAP, "courses"),
                Triple(LearningPage.WORLDS, LearningTags.WORLD_CARDS, WorldGallery.worlds.last().name),
            )) {
                workshop.handle(LearningEvent.PageRequested(page))
                pass(300)
                onNodeWithTag(cards).performScrollToKey(last)
                pass(300)
                for (course in Lessons.strands.map { it.name } + OwnCourses.WORLDS) {
                    onNodeWithTag(LearningTags.courseSave(course)).assertDoesNotExist()
                }
            }
            workshop.handle(LearningEvent.PageClosed)
            workshop.handle(LearningEvent.WorldChosen("maze"))
            pass(300)
            onNodeWithTag(DocumentTags.WORK_MENU).performClick()
            pass(300)
            onNodeWithText("Make an assignment").assertDoesNotExist()
            onNodeWithText("Look at hand-ins").assertDoesNotExist()
        }
}
