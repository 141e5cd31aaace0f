package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.documents.OpenFilesError
import robotran.projects.Course
import robotran.projects.TryResult

/**
 * The state of courses.
 *
 * @property page the page of courses that covers the workshop; null for none.
 * @property open the place of the open project in its course; null if it belongs to none.
 * @property saved what came of saving a course that comes with Robotran; null before that.
 */
@Immutable
data class CourseState(
    val page: CoursePage? = null,
    val open: OpenCourseTask? = null,
    val saved: SavedOwnCourse? = null,
)

/**
 * A course that comes with Robotran was saved as a file.
 *
 * @property name of the course, see [robotran.assignments.course.OwnCourses].
 * @property file its name; null if it could not be saved because of [error].
 */
data class SavedOwnCourse(val name: String, val file: String?, val error: String? = null)

/** A page of courses. */
@Immutable
sealed interface CoursePage {
    /**
     * The courses on this device.
     *
     * @property courses the one used last first.
     * @property removing the key of the course that may be removed; null while nothing is asked.
     */
    data class MyCourses(val courses: List<CourseEntry>, val removing: String? = null) : CoursePage

    /**
     * One course.
     *
     * @property key tells it apart from the others on this device.
     * @property tasks its assignments in their order.
     * @property canBeChanged whether it has what only its author has.
     */
    data class OneCourse(
        val key: String,
        val title: String,
        val text: String,
        val tasks: List<CourseTask>,
        val canBeChanged: Boolean,
    ) : CoursePage {
        /** The index of the assignment to do next: the first that is not done; null if all are. */
        val next: Int? get() = tasks.indexOfFirst { !it.isDone }.takeIf { it >= 0 }
        val done: Int get() = tasks.count { it.isDone }
    }

    /**
     * The page on which a teacher makes a course.
     *
     * @property isKept whether the device keeps it; a course without title or assignments cannot be kept.
     * @property works the assignments in My work, to choose from; null while they are not shown.
     * @property problem why the last action did nothing; null if it did.
     * @property link the link for pupils; null while it is not shown.
     * @property savedAs the name of the last file; null before it.
     */
    data class Making(
        val course: Course,
        val isKept: Boolean = false,
        val works: List<WorkToAdd>? = null,
        val canUndo: Boolean = false,
        val problem: CourseError? = null,
        val link: PupilLink? = null,
        val savedAs: String? = null,
        val hasShareSheet: Boolean = false,
    ) : CoursePage {
        /** Whether it can be given away. */
        val isComplete: Boolean get() = course.title.isNotBlank() && course.assignments.isNotEmpty()
    }
}

/**
 * A course on this device.
 *
 * @property done the number of its [count] assignments of which all goals were met.
 * @property isForTeachers whether it has checks and solutions.
 */
data class CourseEntry(val key: String, val title: String, val done: Int, val count: Int, val isForTeachers: Boolean)

/**
 * An assignment of a course.
 *
 * @property isBegun whether the pupil has a project for it.
 * @property best the pupil's best try; null without one.
 */
data class CourseTask(val id: String, val title: String, val isBegun: Boolean = false, val best: TryResult? = null) {
    val isDone: Boolean get() = best?.isSolved == true
}

/**
 * Where the open project is in its course.
 *
 * @property course the title of the course.
 * @property number of the assignment, from 1, of [count].
 * @property next the title of the next assignment that is not done; null if there is none.
 */
data class OpenCourseTask(val key: String, val course: String, val number: Int, val count: Int, val next: String?)

/** A stored project that can be added to a course. */
data class WorkToAdd(val id: String, val name: String, val title: String)

/** Why a course could not be changed or saved. */
sealed interface CourseError {
    /** The file or project [name] is no assignment. */
    data class NotAnAssignment(val name: String) : CourseError

    data class NotOpened(val error: OpenFilesError) : CourseError

    data class TooMany(val max: Int) : CourseError

    /** It is longer than a file may be. */
    data object TooLong : CourseError

    /** It cannot be kept on the device. */
    data object NotKept : CourseError

    /** [reason] is the platform's message. */
    data class NotSaved(val reason: String) : CourseError
}
