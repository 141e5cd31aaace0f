package robotran.tinyvm.run

/**
 * Which threads have entered which monitors. The monitor of an object has its reference, that of a class a negative
 * number.
 */
internal class Monitors {
    private class Monitor(val owner: VmThread, var entered: Int)

    private val monitors = HashMap<Int, Monitor>()

    /** The monitors that somebody is inside of. */
    val locks: Set<Int> get() = monitors.keys

    fun isFree(lock: Int): Boolean = lock !in monitors

    fun isOwner(lock: Int, thread: VmThread): Boolean = monitors[lock]?.owner === thread

    /** Lets [thread] enter; false if another is inside. */
    fun enter(lock: Int, thread: VmThread): Boolean {
        val monitor = monitors.getOrPut(lock) { Monitor(thread, 0) }
        if (monitor.owner !== thread) return false
        monitor.entered++
        return true
    }

    /** Lets [thread] leave once; false if it is not inside. */
    fun exit(lock: Int, thread: VmThread): Boolean {
        val monitor = monitors[lock]?.takeIf { it.owner === thread } ?: return false
        if (--monitor.entered == 0) monitors -= lock
        return true
    }

    /** Lets [thread], which is inside, leave altogether; returns how often it had entered. */
    fun giveUp(lock: Int, thread: VmThread): Int {
        val monitor = monitors[lock]?.takeIf { it.owner === thread } ?: return 0
        monitors -= lock
        return monitor.entered
    }

    /** Lets [thread] enter a free monitor so many times. */
    fun takeBack(lock: Int, thread: VmThread, times: Int) {
        monitors[lock] = Monitor(thread, times)
    }

    /** Frees all that [thread] is inside of. */
    fun releaseAll(thread: VmThread) {
        monitors.filterValues { it.owner === thread }.keys.forEach { monitors -= it }
    }
}
