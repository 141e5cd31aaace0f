package robotran.workshop.assignment

import robotran.language.history.History
import robotran.projects.Assignment
import robotran.projects.Project
import robotran.workshop.platform.WallClock

/** What an assignment was before its last changes. Typing without a pause is one change. */
internal class AssignmentHistory(private val clock: WallClock) {
    private var history = History<Snapshot>()
    private var lastChange = 0L

    val canUndo: Boolean get() = history.canUndo

    /** [project] is going to get [assignment], or another title or task if it keeps its own. */
    fun add(project: Project, assignment: Assignment?) {
        val now = clock.now
        if (now - lastChange >= PAUSE) history = history.mergeEnded()
        lastChange = now
        val before = Snapshot(project.assignment, project.world.title, project.world.task)
        history = history.recorded(before, mergeKeyOf(project.assignment, assignment))
    }

    fun takeLast(): Snapshot? = history.undone { it }?.let { (before, rest) ->
        history = rest
        before
    }

    fun clear() {
        history = History()
    }

    /** What is typed; null for all changes that are complete in themselves. */
    private fun mergeKeyOf(old: Assignment?, new: Assignment?): String? = when {
        old == new -> "task"
        old == null || new == null -> null
        old.copy(text = new.text) == new -> "text"
        old.copy(due = new.due) == new -> "due"
        old.copy(nameWanted = new.nameWanted) == new -> "name"
        old.hints.size == new.hints.size && old.copy(hints = new.hints) == new -> "hints"
        else -> null
    }

    class Snapshot(val assignment: Assignment?, val title: String, val task: String)

    private companion object {
        /** In milliseconds. */
        const val PAUSE = 1_500L
    }
}
