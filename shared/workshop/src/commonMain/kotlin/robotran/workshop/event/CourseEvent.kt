package robotran.workshop.event

/** A user action on courses. */
sealed interface CourseEvent : SchoolEvent {
    /** Shows the courses on this device. */
    data object ListRequested : CourseEvent

    /** Shows the course [key]. */
    data class CourseChosen(val key: String) : CourseEvent

    /** Closes the page; that of a course leads back to the list. */
    data object PageClosed : CourseEvent

    /** Begins the assignment at [index] of the shown course, or goes on with it. */
    data class TaskChosen(val index: Int) : CourseEvent

    /** Goes on to the next assignment of the course that the open project belongs to. */
    data object NextTaskChosen : CourseEvent

    /** Shows the course that the open project belongs to. */
    data object OpenCourseRequested : CourseEvent

    /** Asks whether the course [key] may be removed; null takes the question back. */
    data class RemovalRequested(val key: String?) : CourseEvent

    /** Removes the course in question. The pupil's work stays in My work. */
    data object Removed : CourseEvent

    /** Saves the course [name] that comes with Robotran as a file, see [robotran.assignments.course.OwnCourses]. */
    data class OwnCourseSaved(val name: String) : CourseEvent

    /** Opens the hand-ins for all assignments of the course [key]. */
    data class HandInsRequested(val key: String) : CourseEvent

    /** Opens the page that makes a course: a new one, or that with the key [key]. */
    data class MakingRequested(val key: String?) : CourseEvent

    /** An action on that page. */
    sealed interface OfAuthor : CourseEvent

    data class TitleChanged(val title: String) : OfAuthor

    data class TextChanged(val text: String) : OfAuthor

    /** Lets the author choose files with assignments or courses. */
    data object FilesRequested : OfAuthor

    /** Shows or hides the assignments in My work. */
    data class WorksShown(val shown: Boolean) : OfAuthor

    /** Adds the stored project [id]. */
    data class WorkAdded(val id: String) : OfAuthor

    /** Moves the assignment at [index] by [by] places. */
    data class TaskMoved(val index: Int, val by: Int) : OfAuthor

    data class TaskRemoved(val index: Int) : OfAuthor

    /** Opens the assignment at [index] as a project, to change it and add it again. */
    data class TaskOpened(val index: Int) : OfAuthor

    /** Takes the last change of the list back. */
    data object UndoRequested : OfAuthor

    /** Saves the file with checks and solutions. */
    data object TeacherFileSaved : OfAuthor

    /** Saves the file for pupils. */
    data object PupilFileSaved : OfAuthor

    data object LinkRequested : OfAuthor

    data object LinkCopied : OfAuthor

    data object LinkShared : OfAuthor

    data object LinkClosed : OfAuthor
}
