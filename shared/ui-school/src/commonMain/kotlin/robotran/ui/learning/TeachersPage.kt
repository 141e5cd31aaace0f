package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.assignments.course.OwnCourses
import robotran.language.Language
import robotran.learning.Lessons
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.LearningTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.SavedOwnCourse

/**
 * What a teacher can make, give out and look at, in one place.
 *
 * @param language the language of the lessons.
 * @param hasGoals whether the open project has goals, for which there may be hand-ins.
 * @param saved what came of saving lessons or worlds as a course.
 */
@Composable
internal fun TeachersPage(
    language: Language,
    hasGoals: Boolean,
    saved: SavedOwnCourse?,
    onEvent: (WorkshopEvent) -> Unit,
) {
    val scroll = rememberScrollState()
    // What opens takes the place of this page.
    val go = { event: WorkshopEvent ->
        onEvent(LearningEvent.PageClosed)
        onEvent(event)
    }
    Page(LearningTexts.teachers(spoken), LearningTags.TEACHERS_PAGE, { onEvent(LearningEvent.PageClosed) }, scroll) {
        Column(
            Modifier.testTag(LearningTags.TEACHERS).verticalScroll(scroll).padding(Space.PAGE),
            Arrangement.spacedBy(Space.WIDE),
        ) {
            Part(SchoolTexts::makeTitle, LearningTexts::teachersMake) {
                Button(SchoolTexts.makeTitle(spoken), LearningTags.TEACHERS_MAKE) {
                    go(AssignmentEvent.MakingRequested)
                }
            }
            Part(
                SchoolTexts::handInsMenu,
                if (hasGoals) LearningTexts::teachersHandIns else LearningTexts::teachersNoGoals,
            ) {
                if (hasGoals) {
                    Button(SchoolTexts.handInsMenu(spoken), LearningTags.TEACHERS_HAND_INS, ButtonKind.SECOND) {
                        go(HandInsEvent.Requested)
                    }
                } else {
                    Button(DocumentTexts.open(spoken), LearningTags.TEACHERS_OPEN, ButtonKind.SECOND) {
                        go(DocumentEvent.OpenRequested)
                    }
                }
            }
            Part(LearningTexts::teachersCourses, LearningTexts::teachersCoursesHelp) {
                Button(SchoolTexts.courseMake(spoken), LearningTags.TEACHERS_COURSE_MAKE, ButtonKind.SECOND) {
                    go(CourseEvent.MakingRequested(null))
                }
                Button(SchoolTexts.courseList(spoken), LearningTags.TEACHERS_COURSES, ButtonKind.SECOND) {
                    go(CourseEvent.ListRequested)
                }
            }
            Part(LearningTexts::teachersOwn, LearningTexts::teachersOwnHelp) {
                for (strand in Lessons.strands) SaveOwnCourse(strand.name, strand.title(language), saved, onEvent)
                SaveOwnCourse(OwnCourses.WORLDS, LearningTexts.worlds(spoken), saved, onEvent)
            }
        }
    }
}

/** A heading, what it is for, and its buttons. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Part(title: Label, help: Label, buttons: @Composable () -> Unit) =
    Column(verticalArrangement = Arrangement.spacedBy(Space.SMALL)) {
        Text(title(spoken), Modifier.heading(), TextStyles.lead.strong)
        Text(help(spoken), style = TextStyles.sentence)
        FlowRow(
            horizontalArrangement = Arrangement.spacedBy(Space.SMALL),
            verticalArrangement = Arrangement.spacedBy(Space.SMALL),
        ) { buttons() }
    }
