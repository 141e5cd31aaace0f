package robotran.tinyvm.run

import robotran.tinyvm.config.MachineModel

/**
 * Chooses the thread to run: one of the highest priority; threads of the same priority take turns. A thread that holds a
 * monitor runs in place of a more important one that waits for it. Sources: leJOS's `threads.c`, and its release notes,
 * which have the avoidance of priority inversion under 2.0.
 *
 * @param clock the brick's clock in milliseconds.
 */
internal class Scheduler(
    private val monitors: Monitors,
    private val model: MachineModel,
    private val clock: () -> Long,
) {
    private val living = ArrayList<VmThread>()
    private var started = 0

    /** By priority, the highest first. */
    private val queues = List(VirtualMachineConstants.MAX_PRIORITY) { RunQueue() }

    /** The started threads that have not ended, in start order. */
    val threads: List<VmThread> get() = living

    /** Whether a non-daemon thread is alive. */
    val hasUserThreads: Boolean get() = living.any { !it.isDaemon }

    val hasRoom: Boolean get() = living.size < model.threads

    fun start(thread: VmThread) {
        thread.state = ThreadState.READY
        thread.number = started++
        living += thread
        queueOf(thread).add(thread)
    }

    fun end(thread: VmThread) {
        thread.state = ThreadState.DEAD
        monitors.releaseAll(thread)
        living -= thread
        queueOf(thread).remove(thread)
        for (other in living) if (other.state == ThreadState.JOINING && other.awaitedThread === thread) goOn(other)
    }

    /** Makes [thread] ready, which has waited for the end of another. */
    private fun goOn(thread: VmThread) {
        thread.awaitedThread = null
        thread.state = ThreadState.READY
    }

    /** Gives [thread], which may not be alive, this [priority]. */
    fun setPriority(thread: VmThread, priority: Int) {
        if (thread.priority == priority) return
        if (thread.isAlive) queueOf(thread).remove(thread)
        thread.priority = priority
        if (thread.isAlive) queueOf(thread).add(thread)
    }

    /**
     * Returns the next thread to run, null if all wait. Threads that wait for a free monitor get it now, whether it is
     * their turn or not.
     */
    fun choose(): VmThread? {
        var chosen: VmThread? = null
        for (queue in queues) {
            val first = queue.first
            for (place in first until first + queue.size) {
                val thread = queue[place]
                wake(thread)
                enterFreeMonitor(thread)
                if (chosen != null) continue
                if (thread.state == ThreadState.READY) {
                    chosen = thread
                    // A brick moves a thread that it starts only after its second turn.
                    if (thread.hasBegun || !model.hasQuirks) queue.moveToEnd(thread)
                    thread.hasBegun = true
                } else if (thread.state == ThreadState.BLOCKED) {
                    chosen = blockerOf(thread)
                }
            }
        }
        return chosen
    }

    /** The earliest time at which a waiting thread wakes by itself, null if none does. */
    val nextWake: Long?
        get() {
            var earliest = Long.MAX_VALUE
            for (thread in living) {
                val sleeps = thread.state == ThreadState.SLEEPING || thread.state == ThreadState.WAITING ||
                    thread.state == ThreadState.JOINING
                if (thread.wakeTime > 0 && sleeps) earliest = minOf(earliest, thread.wakeTime)
            }
            return earliest.takeIf { it < Long.MAX_VALUE }
        }

    /** Wakes all threads that wait for [lock], or only the first one of the highest priority. */
    fun notify(lock: Int, all: Boolean) {
        for (queue in queues) {
            val first = queue.first
            for (place in first until first + queue.size) {
                val thread = queue[place]
                if (thread.state != ThreadState.WAITING || thread.awaitedLock != lock) continue
                thread.state = ThreadState.BLOCKED
                if (model.hasQuirks) thread.isInterruptDue = thread.isInterrupted
                if (!all) return
            }
        }
    }

    private fun queueOf(thread: VmThread): RunQueue = queues[VirtualMachineConstants.MAX_PRIORITY - thread.priority]

    private fun wake(thread: VmThread) {
        val isTime = thread.wakeTime in 1..clock()
        val isInterrupted = model.hasQuirks && thread.isInterrupted
        when (thread.state) {
            ThreadState.SLEEPING -> if (isTime || isInterrupted) {
                thread.state = ThreadState.READY
                thread.isInterruptDue = isInterrupted
            }

            ThreadState.WAITING -> if (isTime || isInterrupted) {
                thread.state = ThreadState.BLOCKED
                thread.isInterruptDue = !isTime
            }

            ThreadState.JOINING -> if (isTime) goOn(thread)
            else -> return
        }
    }

    private fun enterFreeMonitor(thread: VmThread) {
        if (thread.state != ThreadState.BLOCKED || !monitors.isFree(thread.awaitedLock)) return
        monitors.give(thread.awaitedLock, thread, thread.releasedEntries)
        thread.releasedEntries = 0
        thread.state = ThreadState.READY
    }

    /**
     * The thread that can run and holds the monitor that [thread] waits for, or that keeps the holder of that monitor
     * waiting, and so on. Null if there is none, as in a deadlock.
     */
    private fun blockerOf(thread: VmThread): VmThread? {
        var blocked = thread
        repeat(living.size) {
            val owner = monitors.ownerOf(blocked.awaitedLock) ?: return null
            if (owner.state == ThreadState.READY) return owner
            if (owner.state != ThreadState.BLOCKED) return null
            blocked = owner
        }
        return null
    }
}
