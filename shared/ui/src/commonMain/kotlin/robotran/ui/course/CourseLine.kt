package robotran.ui.course

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.ui.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.OpenCourseTask

/** Where the open assignment is in its course, and the ways on and back. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun CourseLine(open: OpenCourseTask, onEvent: (WorkshopEvent) -> Unit) {
    val colours = LocalRobotranColours.current
    Column(Modifier.fillMaxWidth().testTag("course-line")) {
        Text(
            SchoolTexts.coursePlace(spoken, open.course, open.number, open.count),
            Modifier.testTag("course-place"),
            color = colours.quiet,
            fontSize = TextSizes.COMPACT,
            lineHeight = LineHeights.LABEL,
        )
        FlowRow(Modifier, Arrangement.spacedBy(4.dp)) {
            QuietButton(SchoolTexts.courseBack(spoken), "course-line-back", {
                onEvent(CourseEvent.OpenCourseRequested)
            })
            open.next?.let { next ->
                QuietButton(SchoolTexts.courseNext(spoken, next), "course-line-next", {
                    onEvent(CourseEvent.NextTaskChosen)
                })
            }
        }
    }
}
