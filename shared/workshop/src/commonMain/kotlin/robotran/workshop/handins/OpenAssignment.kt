package robotran.workshop.handins

import robotran.assignments.collecting.CollectedFile
import robotran.assignments.collecting.CourseHandIns
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.collectCourse
import robotran.assignments.collecting.collectHandIns
import robotran.assignments.grading.GradingPlan
import robotran.documents.KeyValueStore
import robotran.language.Language
import robotran.projects.Course
import robotran.projects.Project
import robotran.workshop.state.HandInTask
import robotran.workshop.state.HandInsKind
import robotran.workshop.state.HandInsState
import robotran.workshop.state.QrScannerKind

/** An assignment for which hand-ins are graded. */
internal class GradedTask(val project: Project) {
    val plan = GradingPlan.of(project)
    val title: String get() = project.world.title
}

/**
 * A hand-in on the page.
 *
 * @property task the index of its assignment in [OpenAssignment.tasks]; beyond the last if it is for none.
 */
internal class PlacedSubmission(val id: String, val task: Int, val submission: Submission)

/**
 * The assignment that hand-ins are graded for, or all those of a course.
 *
 * @property name of the project or the course.
 * @property project the open one; of a course, its first.
 * @property language of what grading says.
 * @property course null for one assignment.
 */
internal class OpenAssignment(
    val name: String,
    val project: Project,
    val language: Language,
    private val store: KeyValueStore,
    val course: Course? = null,
) {
    val tasks: List<GradedTask> = (course?.assignments ?: listOf(project)).map(::GradedTask)
    val kept = KeptHandIns(
        store,
        course?.run { "course ${id.ifEmpty { title }}" } ?: project.assignment?.id ?: "world ${project.world.title}",
    )

    /** For each of [tasks], and for what is for none. */
    private val submissions = List(tasks.size + 1) { MergedSubmissions() }

    val all: List<PlacedSubmission> get() = submissions.flatMapIndexed { task, merged ->
        merged.all.map { (id, submission) -> PlacedSubmission(idOf(task, id), task, submission) }
    }

    /** The stamps of what was removed. */
    val removed: Set<String> get() = submissions.flatMapTo(mutableSetOf()) { it.removed }

    /** On files that are no hand-ins, in sentences. */
    val notes = linkedSetOf<String>()

    /** Whether the results that the device keeps are those that grading gives today. */
    var areResultsTrue = false

    /** The number of the last link that was pasted or scanned. */
    var lastLink = 0

    suspend fun collect(files: List<CollectedFile>): CourseHandIns {
        if (course != null) return collectCourse(files, course, language)
        val collected = collectHandIns(files, project, language)
        return CourseHandIns(listOf(collected.submissions), emptyList(), collected.notes)
    }

    /** Adds what was found in one batch of files. Returns the hand-ins that are new. */
    fun take(collected: CourseHandIns): List<Submission> {
        notes += collected.notes
        return (collected.tasks + listOf(collected.unsorted)).flatMapIndexed { task, found ->
            submissions[task].add(found)
        }
    }

    /** Removes the hand-in [id]; with [isRemoved] false, it is there again. */
    fun remove(id: String, isRemoved: Boolean = true) = submissions.forEachIndexed { task, merged ->
        val known = merged.all.keys + merged.removedIds
        known.firstOrNull { idOf(task, it) == id }?.let { merged.remove(it, isRemoved) }
    }

    /** Removes each hand-in of which everything is in [stamps]. */
    fun removeAll(stamps: Set<String>) = submissions.forEach { it.removeAll(stamps) }

    /** Whether [project] would give the same grades, in the same words. */
    fun isFor(project: Project, language: Language): Boolean =
        course == null && graded(this.project) == graded(project) && this.language == language

    /** The same for a course. */
    fun isFor(course: Course, language: Language): Boolean = this.course == course && this.language == language

    /** The same without hand-ins. */
    fun emptied() = OpenAssignment(name, project, language, store, course)

    /** A pupil has a hand-in for each assignment of a course. */
    private fun idOf(task: Int, id: String): String = if (course == null || task == 0) id else "${task + 1}. $id"

    /** What matters: the teacher's own tries do not. */
    private fun graded(project: Project) =
        project.withoutViews().withoutFiles().copy(tries = null, inputs = emptyList())

    /**
     * The page before anything is brought in.
     *
     * @param scanners the platform's.
     */
    fun firstState(scanners: List<QrScannerKind>): HandInsState = HandInsState(
        title = course?.title ?: tasks.first().title.ifEmpty { name },
        kind = when {
            project.assignment == null -> HandInsKind.WORLD
            tasks.any { it.project.assignment?.checks == null } -> HandInsKind.WITHOUT_CHECKS
            else -> HandInsKind.WITH_CHECKS
        },
        tasks = tasks.map { task ->
            HandInTask(if (course == null) "" else task.title, task.plan, task.project.assignment?.solution.orEmpty())
        },
        scanners = scanners,
    )
}
