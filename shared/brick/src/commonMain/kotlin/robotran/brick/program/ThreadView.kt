package robotran.brick.program

/**
 * A thread of a program.
 *
 * @property number unique within the run; the first thread has [DebuggableRun.FIRST_THREAD].
 * @property name the name that the pupil sees; not unique.
 * @property priority 1..10, in leJOS; of the runnable threads, one with the highest priority runs.
 * @property isDaemon whether the program ends without waiting for it.
 * @property callStack its active calls, innermost first.
 * @property isCurrent whether it is executing or, while all threads wait, the one to show first.
 */
data class ThreadView(
    val number: Int,
    val name: String,
    val priority: Int = NORMAL_PRIORITY,
    val isDaemon: Boolean = false,
    val activity: ThreadActivity = ThreadActivity.RUNNABLE,
    val callStack: List<CallFrame> = emptyList(),
    val isCurrent: Boolean = false,
) {
    private companion object {
        const val NORMAL_PRIORITY = 5
    }
}

enum class ThreadActivity { RUNNABLE, SLEEPING, WAITING_FOR_MONITOR, WAITING_FOR_NOTIFICATION }
