package robotran.legofirmware.task

import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.model.Assumptions

internal enum class TaskState { STOPPED, READY, WAITING }

/**
 * A task of the running program, or the one that executes requests over infrared light.
 *
 * @property number 0..9, or [REQUESTS].
 */
internal class Task(val number: Int) {
    var state = TaskState.STOPPED
        private set

    /** The moment at which it is ready again, if it waits. */
    var wakesAt = 0L
        private set

    /** Where it continues; null if it was never started. */
    var location: Location? = null

    /** The instruction that it began last; null if none. */
    var begun: Location? = null

    /** Where its subroutine returns to; null if it is in none, or after the return from a nested call. */
    var returnTo: Location? = null

    var priority = Assumptions.TASK_PRIORITY

    /** The events that it waits for; null if none. */
    var monitor: Monitor? = null

    /** The resources that it has asked for; null if none. */
    var access: Monitor? = null

    /** The mask of the events that fired for it last. */
    var activeEvents = 0

    /** Its own variables 32..47, which stay when it ends. */
    val locals = IntArray(FirmwareLimits.LOCAL_VARIABLES)

    val loops = LoopCounters()

    /** Whether it must execute its last instruction again, because the brick was busy. */
    var isRepeating = false

    val isAlive: Boolean get() = state != TaskState.STOPPED

    /** Whether it can execute an instruction at [now]. */
    fun isReady(now: Long): Boolean = isAlive && !isWaiting(now)

    /** Whether it is in the middle of a wait at [now]. */
    fun isWaiting(now: Long): Boolean = state == TaskState.WAITING && now < wakesAt

    /** Where it is at [now]: at the instruction that waits, otherwise before the next one; null if it never started. */
    fun placeAt(now: Long): Location? = if (isWaiting(now)) begun else location

    /** Begins at [start] with nothing left over from before, but for its variables. */
    fun begin(start: Location) {
        location = start
        returnTo = null
        priority = Assumptions.TASK_PRIORITY
        monitor = null
        access = null
        activeEvents = 0
        loops.unwind(0)
        isRepeating = false
        state = TaskState.READY
    }

    fun stop() {
        state = TaskState.STOPPED
        monitor = null
        access = null
    }

    fun waitUntil(moment: Long) {
        state = TaskState.WAITING
        wakesAt = moment
    }

    /** Leaves what it does, also a wait, for the handler of [monitor]. */
    fun handle(monitor: Monitor) {
        location = monitor.handler
        returnTo = monitor.returnTo
        loops.unwind(monitor.loopDepth)
        isRepeating = false
        state = TaskState.READY
    }

    /** Ends a wait that is over. */
    fun wake() {
        state = TaskState.READY
    }

    companion object {
        const val REQUESTS = -1
    }
}

/**
 * What a task asked for, events or resources, and where it continues if they fire or are lost.
 *
 * @property mask a bit for each event or resource.
 * @property returnTo see [Task.returnTo], when the task asked.
 * @property loopDepth number of its loops then.
 */
internal class Monitor(val mask: Int, val handler: Location, val returnTo: Location?, val loopDepth: Int)
