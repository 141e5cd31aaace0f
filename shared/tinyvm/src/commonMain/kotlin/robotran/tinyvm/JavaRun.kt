package robotran.tinyvm

import robotran.rom.CallFrame
import robotran.rom.DebuggableRun

/** A run of a Java program, which may have several threads. The call stack and the variables are those of the thread being executed. */
interface JavaRun : DebuggableRun {
    /** The threads that live, in the order of their start. */
    val threads: List<ThreadView>

    /** What a learner should know about this run so far. */
    val remarks: List<Remark>
}

/**
 * A thread of a program.
 *
 * @property priority 1..10.
 * @property activity what it is doing.
 * @property callStack the program's own methods it is inside of, the innermost first.
 */
data class ThreadView(
    val name: String,
    val priority: Int,
    val isDaemon: Boolean,
    val activity: ThreadActivity,
    val callStack: List<CallFrame>,
)

/** What a thread is doing. */
enum class ThreadActivity { RUNNABLE, SLEEPING, WAITING_FOR_MONITOR, WAITING_FOR_NOTIFICATION }
