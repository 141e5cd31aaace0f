package robotran.assignments.course

import robotran.assignments.doing.pupilCopy
import robotran.assignments.doing.teacherCopy
import robotran.documents.FileStamp
import robotran.json.JsonLimits
import robotran.language.Language
import robotran.projects.Course
import robotran.projects.CourseFileResult
import robotran.projects.Project
import robotran.projects.readCourse
import robotran.projects.writeCourse

/** What pupils get of [course]: no checks, no solutions, and nobody's tries. */
fun pupilCopy(course: Course): Course = course.copy(assignments = course.assignments.map(::pupilCopy))

/** [course] as its author keeps it: with checks and solutions, and nobody's tries. */
fun teacherCopy(course: Course): Course = course.copy(assignments = course.assignments.map(::teacherCopy))

/** Whether [course] holds what only its author has. */
val Course.isForTeachers: Boolean
    get() = assignments.any { it.assignment?.checks != null || it.assignment?.solution.orEmpty().isNotEmpty() }

/**
 * Sixteen hexadecimal digits by which a device tells courses apart: made of the ID, or of the IDs of the assignments if
 * the course has none.
 */
val Course.key: String
    get() = FileStamp.of(id.ifEmpty { assignments.joinToString("\n") { it.assignmentId } }).text

/** The ID of the assignment in this project; empty if it has none. */
val Project.assignmentId: String get() = assignment?.id.orEmpty()

/** [course] as the bytes of a file; null if it is longer than a file may be. */
fun courseFile(course: Course): ByteArray? {
    val text = writeCourse(course)
    if (text.length > JsonLimits.MAXIMUM_CHARACTERS) return null
    return text.takeIf { readCourse(it, Language.ENGLISH) is CourseFileResult.Success }?.encodeToByteArray()
}
