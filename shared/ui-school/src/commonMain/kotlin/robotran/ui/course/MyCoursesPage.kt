package robotran.ui.course

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.CourseTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.CourseEntry
import robotran.workshop.state.CoursePage

/** The courses on this device. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun MyCoursesPage(page: CoursePage.MyCourses, onEvent: (WorkshopEvent) -> Unit) {
    val list = rememberLazyListState()
    Page(SchoolTexts.courseList(spoken), CourseTags.COURSES_PAGE, { onEvent(CourseEvent.PageClosed) }, list) {
        LazyColumn(
            Modifier.fillMaxSize().testTag(CourseTags.COURSES).scrolledByReaders(list) {
                list.layoutInfo.viewportSize.height
            },
            list,
            PaddingValues(20.dp),
            verticalArrangement = Arrangement.spacedBy(12.dp),
        ) {
            if (page.courses.isEmpty()) {
                item(key = "none") {
                    Explanation(SchoolTexts.courseListNone(spoken), Modifier.testTag(CourseTags.COURSES_NONE))
                }
            }
            items(page.courses, key = { it.key }) { CourseRow(it, onEvent) }
            item(key = "actions") {
                FlowRow(
                    Modifier.padding(top = 12.dp),
                    Arrangement.spacedBy(8.dp),
                    Arrangement.spacedBy(8.dp),
                ) {
                    Button(SchoolTexts.courseOpen(spoken), CourseTags.COURSES_OPEN, ButtonKind.SECOND) {
                        onEvent(DocumentEvent.OpenRequested)
                    }
                    Button(SchoolTexts.courseOpenLink(spoken), CourseTags.COURSES_OPEN_LINK, ButtonKind.SECOND) {
                        onEvent(DocumentEvent.LinkPastingRequested)
                    }
                    Button(SchoolTexts.courseMake(spoken), CourseTags.COURSES_MAKE, ButtonKind.SECOND) {
                        onEvent(CourseEvent.MakingRequested(null))
                    }
                }
            }
        }
    }
    page.courses.firstOrNull { it.key == page.removing }?.let { RemovalDialog(it, onEvent) }
}

@Composable
private fun CourseRow(course: CourseEntry, onEvent: (WorkshopEvent) -> Unit) {
    val colours = LocalRobotranColours.current
    Surface(Modifier.fillMaxWidth()) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            Column(
                Modifier
                    .weight(1f)
                    .testTag(CourseTags.course(course.key))
                    .heightIn(min = Dimensions.TARGET)
                    .focusRing()
                    .clip(Shapes.MEDIUM)
                    .clickable(role = Role.Button) { onEvent(CourseEvent.CourseChosen(course.key)) }
                    .padding(16.dp),
                Arrangement.spacedBy(4.dp),
            ) {
                Text(course.title, style = TextStyles.leadSentence.strong)
                Text(
                    SchoolTexts.courseDone(spoken, course.done, course.count),
                    style = TextStyles.body,
                    color = colours.quiet,
                )
                if (course.isForTeachers) {
                    Text(SchoolTexts.courseForTeachers(spoken), style = TextStyles.sentence, color = colours.quiet)
                }
            }
            IconButton(Icon.CLOSE, SchoolTexts.courseRemove(spoken, course.title), CourseTags.remove(course.key)) {
                onEvent(CourseEvent.RemovalRequested(course.key))
            }
        }
    }
}

@Composable
private fun RemovalDialog(course: CourseEntry, onEvent: (WorkshopEvent) -> Unit) {
    val keep = { onEvent(CourseEvent.RemovalRequested(null)) }
    Dialog(
        SchoolTexts.courseRemoveTitle(spoken),
        keep,
        buttons = {
            Button(DocumentTexts.cancel(spoken), CourseTags.COURSE_REMOVE_NO, ButtonKind.DIALOG_OTHER, onClick = keep)
            Button(SchoolTexts.courseRemoveYes(spoken), CourseTags.COURSE_REMOVE_YES, ButtonKind.DIALOG_MAIN) {
                onEvent(CourseEvent.Removed)
            }
        },
    ) {
        Explanation(SchoolTexts.courseRemoveText(spoken, course.title))
        if (course.isForTeachers) Explanation(SchoolTexts.courseRemoveTeachers(spoken))
    }
}
