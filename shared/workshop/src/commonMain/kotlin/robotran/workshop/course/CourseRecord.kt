package robotran.workshop.course

import kotlinx.serialization.Serializable
import robotran.assignments.course.assignmentId
import robotran.assignments.course.isForTeachers
import robotran.assignments.doing.isBetterThan
import robotran.projects.Course
import robotran.projects.TryResult
import robotran.workshop.state.CourseEntry
import robotran.workshop.state.CourseTask

/**
 * What the device remembers of a course beside its file.
 *
 * @property usedAt when it was last opened, in milliseconds since 1970.
 */
@Serializable
internal data class CourseRecord(
    val title: String,
    val isForTeachers: Boolean = false,
    val usedAt: Long = 0,
    val tasks: List<TaskOfRecord> = emptyList(),
) {
    /** The same after the course was opened again as [course]; what the pupil did at its assignments stays. */
    fun with(course: Course, now: Long): CourseRecord {
        val known = tasks.associateBy { it.id }
        val present = course.assignments.map { project ->
            val id = project.assignmentId
            known[id]?.copy(title = project.world.title, isGone = false) ?: TaskOfRecord(id, project.world.title)
        }
        // Work at an assignment that is gone counts again if the assignment comes back.
        val gone = tasks.filter { task -> !task.isEmpty && present.none { it.id == task.id } }
        val all = present + gone.take(MAXIMUM_GONE).map { it.copy(isGone = true) }
        return CourseRecord(course.title, course.isForTeachers, now, all)
    }

    /** The assignments that the course has now. */
    val present: List<TaskOfRecord> get() = tasks.filterNot { it.isGone }

    fun task(id: String): TaskOfRecord? = present.firstOrNull { it.id == id }

    /** The same with [change] of the assignment [id]. */
    fun changed(id: String, change: (TaskOfRecord) -> TaskOfRecord): CourseRecord =
        copy(tasks = tasks.map { if (it.id == id) change(it) else it })

    fun entry(key: String) = present.map { it.shown() }.let { shown ->
        CourseEntry(key, title, shown.count { it.isDone }, shown.size, isForTeachers)
    }
}

/**
 * What the device remembers of an assignment of a course.
 *
 * @property project the ID of the pupil's project for it; null before it was begun.
 * @property best the pupil's best try.
 * @property isGone whether the course no longer has it.
 */
@Serializable
internal data class TaskOfRecord(
    val id: String,
    val title: String,
    val project: String? = null,
    val best: BestOfRecord? = null,
    val isGone: Boolean = false,
) {
    val isEmpty: Boolean get() = project == null && best == null

    fun shown() = CourseTask(id, title, project != null || best != null, best?.result)

    /** The same after a try with this [result]. */
    fun after(result: TryResult): TaskOfRecord =
        if (best == null || result.isBetterThan(best.result)) copy(best = BestOfRecord(result)) else this
}

@Serializable
internal data class BestOfRecord(val met: Int, val goals: Int, val milliseconds: Long, val trace: String) {
    constructor(result: TryResult) : this(result.goalsMet, result.goals, result.milliseconds, result.traceHash)

    val result: TryResult get() = TryResult(met, goals, milliseconds, trace)
}

private const val MAXIMUM_GONE = 60
