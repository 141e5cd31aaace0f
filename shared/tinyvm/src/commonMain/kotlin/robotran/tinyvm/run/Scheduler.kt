package robotran.tinyvm.run

import robotran.tinyvm.config.TinyVmLimits

/**
 * Chooses the thread to run: one of the highest priority; threads of the same priority take turns.
 *
 * @param clock the brick's clock in milliseconds.
 */
internal class Scheduler(private val monitors: Monitors, private val clock: () -> Long) {
    private val living = ArrayList<VmThread>()
    private var last = -1
    private var started = 0

    /** The started threads that have not ended, in start order. */
    val threads: List<VmThread> get() = living

    /** Whether a non-daemon thread is alive. */
    val hasUserThreads: Boolean get() = living.any { !it.isDaemon }

    val hasRoom: Boolean get() = living.size < TinyVmLimits.THREADS

    fun start(thread: VmThread) {
        thread.state = ThreadState.READY
        thread.number = started++
        living += thread
    }

    fun end(thread: VmThread) {
        thread.state = ThreadState.DEAD
        monitors.releaseAll(thread)
        val index = living.indexOf(thread)
        if (index < 0) return
        living.removeAt(index)
        if (index <= last) last--
    }

    /** Returns the next thread to run, null if all wait. */
    fun choose(): VmThread? {
        var best = -1
        for (step in 1..living.size) {
            val index = (last + step).mod(living.size)
            wake(living[index])
            if (canRun(living[index]) && (best < 0 || living[index].priority > living[best].priority)) best = index
        }
        if (best < 0) return null
        last = best
        return living[best].also { reenterMonitor(it) }
    }

    /** The earliest time at which a waiting thread wakes by itself, null if none does. */
    val nextWake: Long?
        get() = living.filter {
            it.wakeTime > 0 && (it.state == ThreadState.SLEEPING || it.state == ThreadState.WAITING)
        }
            .minOfOrNull { it.wakeTime }

    /** Wakes one thread that waits for [lock], or all. */
    fun notify(lock: Int, all: Boolean) {
        for (thread in living) {
            if (thread.state != ThreadState.WAITING || thread.awaitedLock != lock) continue
            thread.state = ThreadState.BLOCKED
            if (!all) return
        }
    }

    private fun wake(thread: VmThread) {
        val isTime = thread.wakeTime in 1..clock()
        when (thread.state) {
            ThreadState.SLEEPING -> if (isTime) thread.state = ThreadState.READY
            ThreadState.WAITING -> if (isTime) thread.state = ThreadState.BLOCKED
            else -> return
        }
    }

    private fun canRun(thread: VmThread): Boolean = thread.state == ThreadState.READY ||
        (thread.state == ThreadState.BLOCKED && monitors.isFree(thread.awaitedLock))

    private fun reenterMonitor(thread: VmThread) {
        if (thread.state != ThreadState.BLOCKED) return
        thread.state = ThreadState.READY
        if (thread.releasedEntries > 0) monitors.reenter(thread.awaitedLock, thread, thread.releasedEntries)
        thread.releasedEntries = 0
    }
}
