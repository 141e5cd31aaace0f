package robotran.projects

import robotran.world.UnknownFields

/**
 * Assignments in the order in which pupils do them. `docs/assignments.md` describes the file format.
 *
 * @property text what the course is about, in paragraphs; empty for none.
 * @property assignments projects with an [Assignment] each; no two have the same ID.
 * @property id the same in all copies of the course, so that one that was opened again takes the place of the older one;
 * empty in a file that was written by hand.
 * @property unknown fields of the file from a newer Robotran or another program.
 */
data class Course(
    val title: String,
    val text: String = "",
    val assignments: List<Project> = emptyList(),
    val id: String = "",
    val unknown: UnknownFields = UnknownFields.NONE,
) {
    companion object {
        const val MAXIMUM_ASSIGNMENTS = 60
    }
}
