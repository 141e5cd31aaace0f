package robotran.ui.course

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.CourseTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.OpenCourseTask

/**
 * The way on from an assignment of a course that is solved.
 *
 * @param handIn the button to hand it in.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
fun NextInCourse(open: OpenCourseTask, onEvent: (WorkshopEvent) -> Unit, handIn: @Composable () -> Unit) {
    FlowRow(Modifier.padding(top = 4.dp), Arrangement.spacedBy(8.dp), Arrangement.spacedBy(8.dp)) {
        open.next?.let { next ->
            Button(SchoolTexts.courseNext(spoken, next), CourseTags.SOLVED_COURSE_NEXT) {
                onEvent(CourseEvent.NextTaskChosen)
            }
        }
        handIn()
        Button(SchoolTexts.courseBack(spoken), CourseTags.SOLVED_COURSE, ButtonKind.SECOND) {
            onEvent(CourseEvent.OpenCourseRequested)
        }
    }
}
