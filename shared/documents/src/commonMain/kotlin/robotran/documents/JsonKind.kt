package robotran.documents

import robotran.projects.isCourseFile

/**
 * Whether the file [name] with this [text] holds a project, a world, a robot or a course: by its content, since a browser
 * or mail program may have changed its name, or else by its name. Null if it is no JSON; one that names no format of ours
 * counts as a world.
 */
fun jsonKindOf(name: String, text: String): FileKind? {
    val plain = plainFileName(name)
    val named = NAMED.entries.firstOrNull { plain.endsWith(it.key, ignoreCase = true) }?.value
    if (named == null && !text.trimStart().startsWith('{')) return null
    return when {
        isCourseFile(text) -> FileKind.COURSE
        PROJECT_MARK in text || named == FileKind.PROJECT -> FileKind.PROJECT
        ROBOT_MARK in text -> FileKind.ROBOT
        WORLD_MARK in text -> FileKind.WORLD
        else -> named ?: FileKind.WORLD
    }
}

private val NAMED = listOf(FileKind.PROJECT, FileKind.WORLD, FileKind.ROBOT).associateBy { it.extension } +
    (COURSE_EXTENSION to FileKind.COURSE)
private const val PROJECT_MARK = "\"robotran-project\""
private const val ROBOT_MARK = "\"robotran-robot\""
private const val WORLD_MARK = "\"robotran-world\""
