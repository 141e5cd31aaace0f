package robotran.ui.course

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.PrimaryButton
import robotran.ui.parts.SecondButton
import robotran.ui.resources.*
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
internal fun NextInCourse(open: OpenCourseTask, onEvent: (WorkshopEvent) -> Unit, handIn: @Composable () -> Unit) {
    FlowRow(Modifier.padding(top = 4.dp), Arrangement.spacedBy(8.dp), Arrangement.spacedBy(8.dp)) {
        open.next?.let { next ->
            PrimaryButton(stringResource(Res.string.course_next, next), "solved-course-next", {
                onEvent(CourseEvent.NextTaskChosen)
            })
        }
        handIn()
        SecondButton(stringResource(Res.string.course_back), "solved-course", {
            onEvent(CourseEvent.OpenCourseRequested)
        })
    }
}
