package robotran.ui.course

import androidx.compose.runtime.Composable
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.CoursePage

/** The pages of courses over the workshop. */
@Composable
fun CoursePages(page: CoursePage, onEvent: (WorkshopEvent) -> Unit) = when (page) {
    is CoursePage.MyCourses -> MyCoursesPage(page, onEvent)
    is CoursePage.OneCourse -> OneCoursePage(page, onEvent)
    is CoursePage.Making -> MakeCoursePage(page, onEvent)
}
