package robotran.legofirmware.task

/**
 * Who may use a motor, the loudspeaker or one of four things of the program. A task of higher priority takes what it
 * wants from others, and so does one of the same priority.
 */
internal class AccessControl(private val tasks: Tasks) {
    /** Asks for the resources of [wanted] for [task], which goes to its handler if it does not get them. */
    fun request(task: Task, wanted: Monitor) {
        task.access = null
        val others = tasks.all.filter { it !== task && it.isAlive && (it.access?.mask ?: 0) and wanted.mask != 0 }
        if (others.any { it.priority < task.priority }) {
            task.handle(wanted)
        } else {
            others.forEach { lose(it) }
            task.access = wanted
        }
    }

    private fun lose(task: Task) {
        val lost = task.access ?: return
        task.access = null
        task.handle(lost)
    }
}
