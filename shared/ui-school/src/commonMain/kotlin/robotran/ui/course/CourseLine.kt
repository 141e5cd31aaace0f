package robotran.ui.course

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.CourseTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.OpenCourseTask

/** Where the open assignment is in its course, and the ways on and back. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
fun CourseLine(open: OpenCourseTask, onEvent: (WorkshopEvent) -> Unit) {
    val colours = LocalRobotranColours.current
    Column(Modifier.fillMaxWidth().testTag(CourseTags.COURSE_LINE)) {
        Text(
            SchoolTexts.coursePlace(spoken, open.course, open.number, open.count),
            Modifier.testTag(CourseTags.COURSE_PLACE),
            TextStyles.compact.copy(lineHeight = LineHeights.LABEL),
            color = colours.quiet,
        )
        FlowRow(Modifier, Arrangement.spacedBy(4.dp)) {
            Button(SchoolTexts.courseBack(spoken), CourseTags.COURSE_LINE_BACK, ButtonKind.QUIET) {
                onEvent(CourseEvent.OpenCourseRequested)
            }
            open.next?.let { next ->
                Button(SchoolTexts.courseNext(spoken, next), CourseTags.COURSE_LINE_NEXT, ButtonKind.QUIET) {
                    onEvent(CourseEvent.NextTaskChosen)
                }
            }
        }
    }
}
