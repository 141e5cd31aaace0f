package robotran.workshop.assignment

import robotran.projects.Assignment
import robotran.projects.Project
import robotran.workshop.platform.WallClock

/** What an assignment was before its last changes. Typing without a pause is one change. */
internal class MakingHistory(private val clock: WallClock) {
    private val before = ArrayDeque<Made>()
    private var lastChange = 0L
    private var lastKind: Any? = null

    val canUndo: Boolean get() = before.isNotEmpty()

    /** [project] is going to get [assignment], or another title or task if it keeps its own. */
    fun add(project: Project, assignment: Assignment?) {
        val now = clock.now
        val kind = kindOf(project.assignment, assignment)
        val goesOn = kind != null && kind == lastKind && now - lastChange < PAUSE && before.isNotEmpty()
        lastChange = now
        lastKind = kind
        if (goesOn) return
        before.addLast(Made(project.assignment, project.world.title, project.world.task))
        if (before.size > MAX_STEPS) before.removeFirst()
    }

    fun takeLast(): Made? {
        lastKind = null
        return before.removeLastOrNull()
    }

    fun clear() {
        before.clear()
        lastKind = null
    }

    /** What is typed; null for all changes that are complete in themselves. */
    private fun kindOf(old: Assignment?, new: Assignment?): String? = when {
        old == new -> "task"
        old == null || new == null -> null
        old.copy(text = new.text) == new -> "text"
        old.copy(due = new.due) == new -> "due"
        old.copy(nameWanted = new.nameWanted) == new -> "name"
        old.hints.size == new.hints.size && old.copy(hints = new.hints) == new -> "hints"
        else -> null
    }

    class Made(val assignment: Assignment?, val title: String, val task: String)

    private companion object {
        /** In milliseconds. */
        const val PAUSE = 1_500L
        const val MAX_STEPS = 100
    }
}
