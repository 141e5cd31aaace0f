package robotran.ui.course

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.projects.AssignmentLimits
import robotran.ui.assignment.Quiet
import robotran.ui.assignment.SaveResult
import robotran.ui.assignment.making.Chips
import robotran.ui.assignment.making.ComesIntoView
import robotran.ui.assignment.making.Field
import robotran.ui.assignment.making.PupilLinkView
import robotran.ui.assignment.making.Section
import robotran.ui.documents.wordsFor
import robotran.ui.school.tags.CourseTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.CourseError
import robotran.workshop.state.CoursePage
import robotran.workshop.state.PupilLink
import robotran.world.WorldLimits

/** The page on which a teacher makes a course. */
@Composable
internal fun MakeCoursePage(page: CoursePage.Making, onEvent: (WorkshopEvent) -> Unit) {
    val scroll = rememberScrollState()
    Page(SchoolTexts.courseMake(spoken), CourseTags.COURSE_MAKE, { onEvent(CourseEvent.PageClosed) }, scroll) {
        Column(
            Modifier.testTag(CourseTags.COURSE_FORM).verticalScroll(scroll).padding(24.dp),
            Arrangement.spacedBy(32.dp),
        ) {
            Explanation(SchoolTexts.courseMakeIntro(spoken))
            Section(SchoolTexts.courseAbout(spoken), CourseTags.COURSE_ABOUT) {
                Field(
                    page.course.title,
                    SchoolTexts.courseTitleLabel(spoken),
                    CourseTags.COURSE_TITLE,
                    WorldLimits.MAXIMUM_TITLE_CHARACTERS,
                ) { onEvent(CourseEvent.TitleChanged(it)) }
                Field(
                    page.course.text,
                    SchoolTexts.courseTextLabel(spoken),
                    CourseTags.COURSE_TEXT,
                    AssignmentLimits.MAXIMUM_TEXT_CHARACTERS,
                    lines = 3,
                ) { onEvent(CourseEvent.TextChanged(it)) }
            }
            CourseTasksSection(page, onEvent)
            GiveSection(page, onEvent)
        }
    }
}

@Composable
private fun GiveSection(page: CoursePage.Making, onEvent: (WorkshopEvent) -> Unit) {
    Section(SchoolTexts.makeGive(spoken), CourseTags.COURSE_GIVE) {
        if (!page.isComplete) {
            Explanation(SchoolTexts.courseIncomplete(spoken), Modifier.testTag(CourseTags.COURSE_INCOMPLETE))
            return@Section
        }
        Quiet(SchoolTexts.makeGiveHelp(spoken), CourseTags.COURSE_GIVE_HELP)
        Chips {
            Button(SchoolTexts.makeTeacherFile(spoken), CourseTags.COURSE_TEACHER_FILE) {
                onEvent(CourseEvent.TeacherFileSaved)
            }
            Button(SchoolTexts.makePupilFile(spoken), CourseTags.COURSE_PUPIL_FILE) {
                onEvent(CourseEvent.PupilFileSaved)
            }
            Button(SchoolTexts.makePupilLink(spoken), CourseTags.COURSE_LINK, ButtonKind.SECOND) {
                onEvent(CourseEvent.LinkRequested)
            }
        }
        ComesIntoView(page.savedAs) { SaveResult(page.savedAs, null, CourseTags.COURSE_SAVED) }
        ComesIntoView(page.link?.run { link ?: problem }) { page.link?.let { CourseLink(it, page, onEvent) } }
    }
}

@Composable
private fun CourseLink(link: PupilLink, page: CoursePage.Making, onEvent: (WorkshopEvent) -> Unit) = PupilLinkView(
    link,
    CourseTags.COURSE,
    SchoolTexts::courseQrHelp,
    onCopy = { onEvent(CourseEvent.LinkCopied) },
    onShare = { onEvent(CourseEvent.LinkShared) }.takeIf { page.hasShareSheet },
)

/** Why the last action did nothing. */
@Composable
internal fun CourseErrorText(problem: CourseError) {
    val words = when (problem) {
        is CourseError.NotAnAssignment -> SchoolTexts.courseProblemOther(spoken, problem.name)
        is CourseError.NotOpened -> wordsFor(problem.error)
        is CourseError.TooMany -> SchoolTexts.courseProblemMany(spoken, problem.max)
        CourseError.TooLong -> SchoolTexts.courseProblemLong(spoken)
        CourseError.NotKept -> SchoolTexts.courseProblemKept(spoken)
        is CourseError.NotSaved -> SchoolTexts.handInNotSaved(spoken, problem.reason).trim()
    }
    Explanation(words, Modifier.testTag(CourseTags.COURSE_PROBLEM).announced(), bad = true)
}
