package robotran.ui.course

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.projects.AssignmentLimits
import robotran.ui.assignment.Quiet
import robotran.ui.assignment.SaveResult
import robotran.ui.assignment.making.Chips
import robotran.ui.assignment.making.ComesIntoView
import robotran.ui.assignment.making.Field
import robotran.ui.assignment.making.PupilLinkView
import robotran.ui.assignment.making.Section
import robotran.ui.documents.Explanation
import robotran.ui.documents.wordsFor
import robotran.ui.parts.Page
import robotran.ui.parts.PrimaryButton
import robotran.ui.parts.SecondButton
import robotran.ui.resources.*
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.CoursePage
import robotran.workshop.state.CourseProblem
import robotran.workshop.state.PupilLink
import robotran.world.WorldLimits

/** The page on which a teacher makes a course. */
@Composable
internal fun MakeCoursePage(page: CoursePage.Making, onEvent: (WorkshopEvent) -> Unit) {
    val scroll = rememberScrollState()
    Page(stringResource(Res.string.course_make), "course-make", { onEvent(CourseEvent.PageClosed) }, scroll) {
        Column(
            Modifier.testTag("course-form").verticalScroll(scroll).padding(24.dp),
            Arrangement.spacedBy(32.dp),
        ) {
            Explanation(stringResource(Res.string.course_make_intro))
            Section(stringResource(Res.string.course_about), "course-about") {
                Field(
                    page.course.title,
                    stringResource(Res.string.course_title_label),
                    "course-title",
                    WorldLimits.MAXIMUM_TITLE_CHARACTERS,
                ) { onEvent(CourseEvent.TitleChanged(it)) }
                Field(
                    page.course.text,
                    stringResource(Res.string.course_text_label),
                    "course-text",
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
    Section(stringResource(Res.string.make_give), "course-give") {
        if (!page.isComplete) {
            Explanation(stringResource(Res.string.course_incomplete), Modifier.testTag("course-incomplete"))
            return@Section
        }
        Quiet(stringResource(Res.string.make_give_help), "course-give-help")
        Chips {
            PrimaryButton(stringResource(Res.string.make_teacher_file), "course-teacher-file", {
                onEvent(CourseEvent.TeacherFileSaved)
            })
            PrimaryButton(stringResource(Res.string.make_pupil_file), "course-pupil-file", {
                onEvent(CourseEvent.PupilFileSaved)
            })
            SecondButton(stringResource(Res.string.make_pupil_link), "course-link", {
                onEvent(CourseEvent.LinkRequested)
            })
        }
        ComesIntoView(page.savedAs) { SaveResult(page.savedAs, null, "course-saved") }
        ComesIntoView(page.link?.run { link ?: problem }) { page.link?.let { CourseLink(it, page, onEvent) } }
    }
}

@Composable
private fun CourseLink(link: PupilLink, page: CoursePage.Making, onEvent: (WorkshopEvent) -> Unit) = PupilLinkView(
    link,
    "course",
    Res.string.course_qr_help,
    onCopy = { onEvent(CourseEvent.LinkCopied) },
    onShare = { onEvent(CourseEvent.LinkShared) }.takeIf { page.hasShareSheet },
)

/** Why the last action did nothing. */
@Composable
internal fun CourseProblemText(problem: CourseProblem) {
    val words = when (problem) {
        is CourseProblem.NotAnAssignment -> stringResource(Res.string.course_problem_other, problem.name)
        is CourseProblem.NotOpened -> wordsFor(problem.error)
        is CourseProblem.TooMany -> stringResource(Res.string.course_problem_many, problem.max)
        CourseProblem.TooLong -> stringResource(Res.string.course_problem_long)
        CourseProblem.NotKept -> stringResource(Res.string.course_problem_kept)
        is CourseProblem.NotSaved -> stringResource(Res.string.hand_in_not_saved, problem.reason).trim()
    }
    Explanation(words, Modifier.testTag("course-problem").semantics { liveRegion = LiveRegionMode.Polite }, bad = true)
}
