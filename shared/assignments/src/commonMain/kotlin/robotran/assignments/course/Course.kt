package robotran.assignments.course

import robotran.projects.Project
import robotran.world.UnknownFields

/**
 * Several assignments, in the order in which pupils do them. `docs/assignments.md` describes the file format.
 *
 * @property text about the course, in paragraphs.
 * @property assignments each has a [Project.assignment] of its own.
 */
data class Course(
    val title: String,
    val text: String,
    val assignments: List<Project>,
    val unknown: UnknownFields = UnknownFields.NONE,
)

/** The limits of a [Course]. [robotran.json.JsonLimits] limits the whole file, or each of a folder. */
object CourseLimits {
    const val MAXIMUM_ASSIGNMENTS = 100

    /** Of the text about the course. */
    const val MAXIMUM_TEXT_CHARACTERS = 10_000
}
