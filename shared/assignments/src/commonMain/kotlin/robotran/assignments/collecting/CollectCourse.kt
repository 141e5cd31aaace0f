package robotran.assignments.collecting

import robotran.assignments.messages.CollectingMessages
import robotran.language.Language
import robotran.projects.Course

/**
 * What a teacher has collected for a course.
 *
 * @property tasks for each assignment, in the order of the course.
 * @property unsorted what is for none of them, or does not say for which.
 * @property notes as in [CollectedHandIns].
 */
class CourseHandIns(
    val tasks: List<List<Submission>>,
    val unsorted: List<Submission.Unusable>,
    val notes: List<String>,
)

/**
 * As [collectHandIns] for all assignments of [course] together. Hand-ins of the app and their links say which one they
 * are for. A program says it by a folder, a zip or its own name with the assignment's title in it.
 */
suspend fun collectCourse(files: List<CollectedFile>, course: Course, language: Language): CourseHandIns {
    val messages = CollectingMessages.of(language)
    val sorting = CourseSorting(course)
    val found = Unpacking(messages).unpack(files).map(sorting::sort)
    val ids = course.assignments.mapNotNull { it.assignment?.id }
    val readers = course.assignments.map { GroupReader(it, language, ids.toSet() - it.assignment?.id.orEmpty()) }
    // A pupil's folder is one for all assignments, also where it has little for each.
    val groups = groupsOf(found) { file -> readers.any { it.isNoHandIn(file) } }
    val all = readers.mapIndexed { task, reader ->
        collectGroups(groups.mapNotNull { group -> group.only { saysItself(it) || it.task == task } }, reader)
    }
    // What no assignment takes is the same in all of them.
    val foreign = all.map { it.submissions.filterIsInstance<Submission.Unusable>().toSet() }
        .reduceOrNull(Set<Submission.Unusable>::intersect).orEmpty().takeIf { all.size > 1 }.orEmpty()
    // A link has no world, so another assignment may find it broken.
    val read = all.flatMap { it.submissions }.filterIsInstance<Submission.Usable>().mapTo(mutableSetOf()) { it.origin }
    val tasks = all.map { ofTask ->
        (ofTask.submissions - foreign).filterNot {
            it is Submission.Unusable && it.project == null && it.origin in read
        }
    }
    val known = tasks.flatten().mapTo(mutableSetOf()) { keyOf(it.name) }
    val silent = groups.mapNotNull { group -> group.only { !saysItself(it) && it.task == null } }
    val rest = course.assignments.firstOrNull()?.let { unsortedOf(silent, GroupReader(it, language), messages, known) }
    return CourseHandIns(
        limited(tasks, CollectingLimits.MAXIMUM_SUBMISSIONS, messages),
        (foreign.filterNot { keyOf(it.name) in known && it.project == null } + rest.orEmpty()).distinct(),
        all.flatMap { it.notes }.distinct(),
    )
}

/** Whether [file] may hold projects or links, which say which assignment they are for. */
private fun saysItself(file: FoundFile): Boolean = file.kind == FoundKind.TEXT

/**
 * What lies where nothing says which assignment it is for.
 *
 * @param known keys of pupils with rows, who get none for what is no program.
 */
private suspend fun unsortedOf(
    groups: List<FileGroup>,
    reader: GroupReader,
    messages: CollectingMessages,
    known: Set<String>,
): List<Submission.Unusable> = collectGroups(groups, reader).submissions.mapNotNull { submission ->
    when (submission) {
        is Submission.Unusable -> submission.takeUnless { keyOf(it.name) in known }
        is Submission.Usable -> Submission.Unusable(submission.name, submission.origin, messages.noTask())
    }
}

private fun limited(tasks: List<List<Submission>>, max: Int, messages: CollectingMessages): List<List<Submission>> {
    var room = max
    return tasks.map { ofTask ->
        val taken = ofTask.take(room)
        room -= taken.size
        val rest = ofTask.size - taken.size
        if (rest == 0) taken else taken + Submission.Unusable(messages.others(), "", messages.leftOut(rest, max))
    }
}

private class CourseSorting(course: Course) {
    private val titles = course.assignments.map { lettersOf(it.world.title) }

    /** A folder that is called after an assignment is no pupil's, so it is left out of the path. */
    fun sort(file: FoundFile): FoundFile {
        val folders = file.path.dropLast(1)
        val place = folders.indexOfFirst { taskIn(it) != null && PlatformName.of(it) == null }
        val task = folders.getOrNull(place)?.let(::taskIn) ?: taskIn(stemOf(file.name))
        val path = if (place < 0) file.path else file.path.take(place) + file.path.drop(place + 1)
        return file.at(path).of(task)
    }

    /** The assignment with the longest title in [name]. */
    private fun taskIn(name: String): Int? {
        val letters = lettersOf(name)
        return titles.indices.filter { titles[it].length >= FEWEST_LETTERS && titles[it] in letters }
            .maxByOrNull { titles[it].length }
    }

    private fun lettersOf(name: String): String = foldedName(name).filter { it.isLetterOrDigit() }

    private companion object {
        const val FEWEST_LETTERS = 3
    }
}
