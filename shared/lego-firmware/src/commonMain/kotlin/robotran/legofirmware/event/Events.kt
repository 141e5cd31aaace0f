package robotran.legofirmware.event

import robotran.legofirmware.model.Assumptions
import robotran.legofirmware.task.Tasks

/** The 16 events, and the tasks that wait for them. */
internal class Events(private val readings: EventReadings, private val tasks: Tasks) {
    private val all = List(COUNT) { Event() }
    private var messageArrived = false

    operator fun get(number: Int): Event? = all.getOrNull(number)

    fun define(number: Int, source: Int, type: Int) {
        all.getOrNull(number)?.define(EventSource.of(source), EventType.of(type))
    }

    fun clear() = all.forEach { it.clear() }

    fun calibrate(number: Int, upper: Int, lower: Int, hysteresis: Int, now: Long) {
        all.getOrNull(number)?.calibrate(readings, upper, lower, hysteresis, now)
    }

    fun noteMessage() {
        messageArrived = true
    }

    /** Checks all events, as often as the brick reads its sensors. */
    fun tick(now: Long) {
        if (now % Assumptions.EVENT_MILLISECONDS != 0L) return
        var fired = 0
        all.forEachIndexed { number, event ->
            if (event.check(readings, messageArrived, now)) fired = fired or (1 shl number)
        }
        messageArrived = false
        if (fired != 0) fire(fired)
    }

    /** Sends each task that waits for one of the events of [mask] to its handler. */
    fun fire(mask: Int) {
        for (task in tasks.all) {
            val monitor = task.monitor ?: continue
            val active = monitor.mask and mask
            if (active == 0 || !task.isAlive) continue
            task.monitor = null
            task.activeEvents = active
            task.handle(monitor)
        }
    }

    private companion object {
        const val COUNT = 16
    }
}
