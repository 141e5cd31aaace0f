package robotran.tinyvm.run

/**
 * The monitors that threads are inside of. The key of an object's monitor is its reference; the key of a class's
 * monitor is negative.
 */
internal class Monitors {
    private class Monitor(val owner: VmThread, var entered: Int)

    private val monitors = HashMap<Int, Monitor>()

    /** The monitors that a thread is inside of. */
    val locks: Set<Int> get() = monitors.keys

    fun isFree(lock: Int): Boolean = lock !in monitors

    fun isOwner(lock: Int, thread: VmThread): Boolean = monitors[lock]?.owner === thread

    /** The thread inside of the monitor, null if it is free. */
    fun ownerOf(lock: Int): VmThread? = monitors[lock]?.owner

    /** Enters the monitor for [thread]; returns false if another thread is inside. */
    fun enter(lock: Int, thread: VmThread): Boolean {
        val monitor = monitors.getOrPut(lock) { Monitor(thread, 0) }
        if (monitor.owner !== thread) return false
        monitor.entered++
        return true
    }

    /** Exits the monitor once; returns false if [thread] is not inside. */
    fun exit(lock: Int, thread: VmThread): Boolean {
        val monitor = monitors[lock]?.takeIf { it.owner === thread } ?: return false
        if (--monitor.entered == 0) monitors -= lock
        return true
    }

    /** Exits the monitor completely; returns how often [thread] had entered it. */
    fun exitCompletely(lock: Int, thread: VmThread): Int {
        val monitor = monitors[lock]?.takeIf { it.owner === thread } ?: return 0
        monitors -= lock
        return monitor.entered
    }

    /**
     * Gives a free monitor to [thread] and enters it [times] times. With 0 times, nobody else can enter it before
     * [thread] has done so.
     */
    fun give(lock: Int, thread: VmThread, times: Int) {
        monitors[lock] = Monitor(thread, times)
    }

    /** Exits all monitors of [thread]. */
    fun releaseAll(thread: VmThread) {
        monitors.filterValues { it.owner === thread }.keys.forEach { monitors -= it }
    }
}
