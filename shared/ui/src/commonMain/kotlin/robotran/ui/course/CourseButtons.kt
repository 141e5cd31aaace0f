package robotran.ui.course

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.assignment.SaveResult
import robotran.ui.learning.PrimaryButton
import robotran.ui.learning.QuietButton
import robotran.ui.learning.SecondButton
import robotran.ui.resources.Res
import robotran.ui.resources.course_back
import robotran.ui.resources.course_next
import robotran.ui.resources.course_save_own
import robotran.ui.resources.course_save_own_of
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.OpenCourseTask
import robotran.workshop.state.SavedOwnCourse

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

/** Saves the course [name], which comes with Robotran and is called [title] here, as a file. */
@Composable
internal fun SaveOwnCourse(name: String, title: String, saved: SavedOwnCourse?, onEvent: (WorkshopEvent) -> Unit) {
    // Several such buttons on a page sound alike otherwise.
    val words = stringResource(Res.string.course_save_own_of, title)
    QuietButton(
        stringResource(Res.string.course_save_own),
        "course-save-$name",
        { onEvent(CourseEvent.OwnCourseSaved(name)) },
        modifier = Modifier.semantics { contentDescription = words },
    )
    if (saved?.name == name) SaveResult(saved.file, saved.error, "course-saved-$name")
}
