package robotran.rcxrom.program

/**
 * A thread of a program.
 *
 * @property number its own as long as the run lasts; the thread that a program begins with has
 * [DebuggableRun.FIRST_THREAD].
 * @property name what a pupil knows it by; several may have the same.
 * @property priority 1..10, in leJOS; of threads that could go on, one of the highest does.
 * @property isDaemon whether the program ends without waiting for it.
 * @property activity what it is doing.
 * @property callStack what it is in the middle of, the innermost first.
 * @property isCurrent whether it is the one being executed, or, while all wait, the one to look at first.
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

/** What a thread is doing. */
enum class ThreadActivity { RUNNABLE, SLEEPING, WAITING_FOR_MONITOR, WAITING_FOR_NOTIFICATION }
