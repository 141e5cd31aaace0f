package robotran.legofirmware.event

import robotran.legofirmware.model.Assumptions
import robotran.legofirmware.model.wrapped

/** One of the 16 events. Its limits stay when its definition changes. */
internal class Event {
    private var source: EventSource? = null
    private var type: EventType? = null
    private var before: Readings? = null
    private var calibratesUntil: Long? = null
    private val clicks = ClickTimes()

    var upper = 0
    var lower = 0
    var hysteresis = 0

    /** In 10 ms. */
    var clickTime = Assumptions.CLICK_TIME
    var clickCount = 0

    var state = EventState.UNDEFINED
        private set

    private class Readings(val value: Int, val boolean: Int, val raw: Int)

    /** A source or type that is unknown clears the definition. */
    fun define(source: EventSource?, type: EventType?) {
        clear()
        if (source == null || type == null) return
        this.source = source
        this.type = type
    }

    fun clear() {
        source = null
        type = null
        before = null
        calibratesUntil = null
        state = EventState.UNDEFINED
        clicks.forget()
    }

    /** Sets the limits as far from the present reading as the given percentages of it. */
    fun calibrate(readings: EventReadings, upperPercent: Int, lowerPercent: Int, hysteresisPercent: Int, now: Long) {
        val value = source?.let { readings.value(it) } ?: return
        upper = wrapped(value + value * upperPercent / PERCENT)
        lower = wrapped(value - value * lowerPercent / PERCENT)
        hysteresis = wrapped(value * hysteresisPercent / PERCENT)
        state = EventState.CALIBRATION_BEGINS
        calibratesUntil = now + Assumptions.CALIBRATION_MILLISECONDS
    }

    /** Takes the present readings, and returns whether the event fires. */
    fun check(readings: EventReadings, messageArrived: Boolean, now: Long): Boolean {
        val source = source ?: return false
        val present = Readings(readings.value(source), readings.boolean(source), readings.raw(source))
        val previous = before
        before = present
        if (isCalibrating(now)) return false
        val stateBefore = state
        state = nextState(present.value)
        if (previous == null) return false
        val change = present.value != previous.value
        val click = clicks.follow(stateBefore, state, now, clickTime)
        if (click != null) clickCount = wrapped(clickCount + 1)
        return when (type) {
            EventType.PRESSED -> previous.boolean == 0 && present.boolean != 0
            EventType.RELEASED -> previous.boolean != 0 && present.boolean == 0
            EventType.PULSE -> change && readings.mode(source) and MODES == PULSE_MODE
            EventType.EDGE -> change && readings.mode(source) and MODES == EDGE_MODE
            EventType.FAST_CHANGE -> isFast(present.raw - previous.raw, readings.mode(source) and SLOPES)
            EventType.LOW -> entered(EventState.LOW, stateBefore)
            EventType.NORMAL -> entered(EventState.NORMAL, stateBefore)
            EventType.HIGH -> entered(EventState.HIGH, stateBefore)
            EventType.CLICK -> click != null
            EventType.DOUBLE_CLICK -> click == ClickTimes.Click.SECOND
            EventType.MESSAGE -> messageArrived && source == EventSource.Message
            null -> false
        }
    }

    private fun isCalibrating(now: Long): Boolean {
        val end = calibratesUntil ?: return false
        if (now < end) {
            state = EventState.CALIBRATING
            return true
        }
        calibratesUntil = null
        state = EventState.UNDEFINED
        return false
    }

    private fun entered(range: EventState, before: EventState): Boolean =
        state == range && before != range && before != EventState.UNDEFINED

    private fun nextState(value: Int): EventState = when {
        value < lower -> EventState.LOW
        value > upper -> EventState.HIGH
        state == EventState.LOW && value <= lower + hysteresis -> EventState.LOW
        state == EventState.HIGH && value >= upper - hysteresis -> EventState.HIGH
        else -> EventState.NORMAL
    }

    private fun isFast(change: Int, slope: Int): Boolean = slope != 0 && (change > slope || -change > slope)

    private companion object {
        const val PERCENT = 100
        const val MODES = 0xE0
        const val SLOPES = 0x1F
        const val EDGE_MODE = 0x40
        const val PULSE_MODE = 0x60
    }
}
